#!/bin/sh
# Writes docs/truth.md: heights of scenes from laser clouds, and their errors.
# Usage: docs/truth.sh path/to/terratact [SCENES]
#   SCENES   simulated scenes of each trial, default 400: half a minute on two cores
set -eu
terratact=$(realpath "$1")
scenes=${2:-400}
cd "$(dirname "$0")"
page=$(mktemp)
work=$(mktemp -d)
trap 'rm -rf "$page" "$work"' EXIT

# trial LABEL CLOUD-OPTIONS TRUTH-OPTIONS: prints a row of the table.
trial() {
  # shellcheck disable=SC2086
  "$terratact" simulate --terrain varied --tracks --exact-truth --count "$scenes" --seed 11 --out "$work/s.csv" \
    --cloud "$work/c.pcd" --poses "$work/p.csv" $2 >/dev/null
  # shellcheck disable=SC2086
  "$terratact" truth "$work/c.pcd" --scenes "$work/s.csv" --poses "$work/p.csv" --out "$work/t.csv" $3 >"$work/report"
  offset=$(sed -nE 's/.* cloud lies ([0-9.]+) ± ([0-9.]+) mm (above|below).*/\1 ± \2 \3/p' "$work/report")
  known=$(sed -nE 's/.* scenes with ([0-9]+) known.*/\1/p' "$work/report")
  all=$(sed -nE 's/^[0-9]+ points .* of ([0-9]+) scenes have.*/\1/p' "$work/report")
  row="| $1 | $((100 * known / (22 * all))) % | $offset"
  for part in 'under the tracks' 'ahead,'; do
    row="$row | $(sed -nE "s/^ *$part.*bias ([-+0-9.]+) mm.*rms ([0-9.]+) mm, worst ([0-9]+) mm, ([0-9]+) % within.*/\1, \2, \3 | \4 %/p" \
      "$work/report")"
  done
  echo "$row |"
}

{
  cat <<'TEXT'
# Truth from laser clouds

`terratact truth` finds the true heights of scenes in point clouds. The scenes come from `terratact import --scenes`
([import.md](import.md)), from `session scenes`, or from `simulate`. The output is a scenes file with heights, for `train` and `evaluate`.

| input | read |
|---|---|
| cloud | PCD: ascii, binary, binary_compressed, every number type. PLY: ascii, both byte orders. Text: x y z in m, by the first columns or by name. Decimal commas are read between semicolons, tabs or blanks. PTS is read, too. LAS and LAZ are not read, because Debian 12 packages no library for them; convert them to PLY or text. |
| scans | with `--scans`, clouds in the sensor's frame, named by their times (`1436509052.25.pcd`). With `--topic`, messages of PointCloud2 in the recordings that `import` reads. `--sensor-mount` says where the sensor is, or with `--tf-base base_link` /tf and /tf_static of the recordings |
| poses | TUM (`time x y z qx qy qz qw`), or CSV with these columns and possibly `run`. With `--mapping`, the odometry of a recording: a topic, or the transforms between two frames. `--pose-mount` says where their frame is in the base |
| scenes | of one plane, or of left and right. Scenes in a file of drives get heights, too ([import.md](import.md#drives-with-their-way)). Their `t_s` counts from the begin of the drive: `--session` or `--start` gives the poses' clock there |

The cloud's frame has z up. Of a pose only place and heading count for a scene: pitch and roll are those that the robot measured.

## From a drive to heights

The first command stands in for a robot's drive and its laser map, which lies 4 cm too high:

    $ terratact simulate --terrain varied --tracks --count 40 --seed 2 --out scenes.csv --cloud map.pcd --poses poses.csv --cloud-holes 0.1 --cloud-offset 0.04
    40 scenes over varied written to scenes.csv
    … points written to map.pcd, poses to poses.csv
    $ terratact truth map.pcd --scenes scenes.csv --poses poses.csv --out truth.csv --align --support support.csv --sheet sheet.png
    … points of 1 clouds; 40 of 40 scenes have heights
    alignment: over 40 scenes the cloud lies … mm above the robot's tracks; scatter … mm
    …
    alignment: offset and tilt were removed
    against the heights that scenes.csv held:
    …
    40 scenes with … known heights written to truth.csv
    $ head -n 2 support.csv
    run,t_s,side,bin_m,height_m,sd_m,points,cells
    1,0,left,-0.3,…

Look at `sheet.png` before you train. For up to 40 scenes it shows the cloud's slice, the robot and the bins.

## Decide scene by scene

The paper sampled its truth by hand. `--review` writes a truth file for the console. It shows the slice of each scene's cloud, the robot and
the bins with one and two sd:

    $ terratact truth map.pcd --scenes scenes.csv --poses poses.csv --out truth.csv --align --review drive.truth
    …
    40 scenes with … known heights written to truth.csv

`terratact-console drive.truth`, or *Open* in any window, opens it. Keys: A accepts a scene, X excludes it, and the next open scene appears.
U and D move the heights up and down by 5 mm. F and G tilt the ground ahead up and down by 0.005 rad. K moves the cloud ahead by 2 cm under
the robot, J moves it back, at most 0.2 m. 0 takes the nudge away. Ctrl+Z undoes. The decisions are saved by themselves in
`drive.truth.decisions.csv`. The truth file is never changed. Ctrl+E writes the scenes with the decisions under a new name.

A nudge along samples every bin again from the cells of the scene. Heights, sd and the robot's own points follow. The boundary of the
robot at its other poses moves with it, because one drive usually has one error of its poses. The truth file holds these cells, at most
243 MB of heights. Files of the first version hold a slice instead: they open, but are not nudged along. A person who corrects many
scenes of a drive in one direction should correct the poses, and run `truth` again.

The same decisions act on the command line. A run beside the row guards against decisions on other scenes. Scenes without a decision are accepted:

    $ printf 'row,run,decision,offset_m,tilt_rad,along_m\n3,,exclude,,,\n5,,accept,-0.01,0.005,\n7,,accept,,,0.04\n' >decisions.csv
    $ terratact truth map.pcd --scenes scenes.csv --poses poses.csv --out decided.csv --align --decisions decisions.csv --sheet decided.png
    … points of 1 clouds; 39 of 40 scenes have heights, 1 are excluded by decision
    …
    40 scenes with … known heights written to decided.csv

An excluded scene keeps its row without heights. An offset is at most 0.2 m, a tilt 0.17 rad. `along_m` is a multiple
of 0.02, at most 0.2; a file without this column is read, too. The errors against heights that the scenes held
are those before the decisions.

## How it works

- **Cells.** Under each scene, points fall into cells of 2 cm along four lines. These are the left and right track and flippers of the
  [robot file](robot.md), each as wide as the part. A cell keeps up to 48 heights as a fair sample. Memory grows with the scenes, at most
  243 MB, and not with the cloud. 20 million points around 200 scenes in one hall took 14 s and 31 MB on two busy processors. At most 500
  scenes may lie over the same ground: choose a run with `--run`, or split the file.
- **Own points.** The ground is nowhere inside the robot. What lies 3 cm above its lower boundary at any pose of the drive is left out. In a
  noisy cloud that is three sd, at most 6 cm. Of a scan, all points in the box that the robot can fill are left out, too.
- **Ground.** A cell's height is the median of its points. Among plants, `--percentile 15` takes the ground below them. On bare ground it is
  too low by one sd of the noise. Of two levels with a gap of 0.35 m, such as floor and table, the lower one counts.
- **Bins.** A bin is the mean of its five cells. It needs three; cells in a hole are interpolated. Its sd has the spread and number of
  points, the rise across holes, and the scatter of the alignment. Bins with an sd above `--max-sd` stay empty. `--support` writes sd,
  points and cells of each bin.
- **sd.** The output holds the sd of each height in the columns `sd_-0.3_m` … (`left_sd_-0.3_m` …). Scenes files without them have exact heights.
- **One plane.** A file of one plane gets the mean of both sides, and half of their difference as sd.

## What the sd does

`train` adds the square of each height's sd to the noise of that row, for all its Gaussian processes. A doubtful height then follows the
others instead of pulling at them. The spread that the model learns is the ground's, not the scanner's. 500 generated scenes with exact
heights were given noise. Its sd was 80 mm in 40 % of the scenes, 3 mm in the others. Errors and bands on 299 other scenes with exact
heights, method `local`:

| trained on | median error [mm] | mean error [mm] | CRPS [mm] | 80 % band covers | width [mm] |
|---|---|---|---|---|---|
| exact heights | 19.1 | 32.9 | 24.9 | 70 % | 95 |
| noisy heights | 19.2 | 32.8 | 25.4 | 87 % | 140 |
| noisy heights with their sd | 15.9 | 31.3 | 24.0 | 83 % | 103 |

`evaluate` counts the sd, too. Bands, CRPS and PIT are those of what the scanner would read. The report says which share of the squared
error the truth itself has. |error| stays as it is. So does the width of the band, which is the operator's. Heights with 30 mm of noise lay
in the 80 % band of `local` in 54 % of the bins. That is without their sd. With it, 76 % lay there (70 % with exact heights). The baselines
`flat` … `gp-s` learn without the sd. In the loss of the networks of `trail`, a height with the sd *s* has the weight r² / (r² + s²).
There r is 20 mm, the error of the networks on exact heights. An unknown height has the weight 0.

## What an empty bin does

A scene with unknown heights counts for its other bins. The surface processes of `joint`, `local` and both sides learn each bin from every
row that knows it. `local` takes the residual of an unknown bin from the nearest scene that knows it. The covariance of `joint` comes from
complete scenes. The conditionals of the sampling methods and the baselines take complete scenes alone. `train` says how many scenes have
unknown heights. The model file marks them in a table of their own. This rule leaves a model of complete scenes unchanged, byte by byte.
`evaluate` scores the known bins and prints their number.

Of 78 scenes behind a cloud with 25 % holes, 72 had an unknown bin. `train --tracks` learnt from all 78. Without every scene with a hole
there would be 6, fewer than the 30 that it needs.

## Alignment

At rest, the robot's tracks and flippers touch the ground in front of and behind its centre of mass. For each scene the line that
touches the gap between robot and cloud there gives an offset and a tilt. The medians over all scenes are printed. The tilt is the robot's (a mounting) or
the map's (its z is not gravity), whichever explains more. `--align` removes both. A scene whose offset differs by more than 5 cm and four
scatters stays empty: its pose jumped. An offset along or across the way cannot be seen so.

If the alignment is large, nothing is known well enough without `--align`: the offset is part of every sd.

## Bad input

Every refusal is one sentence with file, line, what was expected and what to do; nothing is written. A cloud that ends too early, or whose
header does not agree with its points, is refused. So are bytes behind the last point, unless they are zeros. So are poses that jump faster than `--max-speed`, times that do not rise, and quaternions
of another length. Points that are NaN are counted and left out.

    $ head -c 100000 map.pcd > half.pcd
    $ terratact truth half.pcd --scenes scenes.csv --poses poses.csv --out other.csv
    terratact: half.pcd: ends within the last … of … points of 12 bytes that its header declares: it is cut; write it again
    $ terratact truth map.pcd --scenes scenes.csv --poses poses.csv --out other.csv --start 7200
    terratact: poses.csv: has poses from 0.000 to … s, but the scenes are from 7200.000 to … s, or more than 0.5 s from two poses: give the clock's time at t_s = 0 by --start or --session, or raise --max-gap

## Error of the truth

TEXT
  echo "Simulated drives, $scenes scenes each, over random ground whose heights are known. The clouds have 4000 points per square metre with 1 cm of"
  echo 'noise unless the row says otherwise. Errors are bias, rms and the largest one in mm. The last column is the share of errors within the 80 %'
  echo 'band (1.28 sd). `docs/truth.sh` made this table with `simulate --exact-truth --cloud` and `truth`:'
  echo
  echo '| cloud | known bins | cloud above or below the tracks [mm] | under the tracks | in band | ahead, from +0.3 m | in band |'
  echo '|---|---|---|---|---|---|---|'
  trial 'as above' '' ''
  trial '2 cm of noise' '--cloud-noise 0.02' ''
  trial '20 % holes' '--cloud-holes 0.2' ''
  trial '5 cm too low, `--align`' '--cloud-offset -0.05' '--align'
  trial '5 cm too high, map tilted by 1.7°, `--align`' '--cloud-offset 0.05 --cloud-tilt 0.03' '--align'
  trial '300 points of the robot at each pose' '--cloud-own 300' ''
  trial 'all of it: 2 cm of noise, 20 % holes, 5 cm too high, tilted, own points, `--align`' \
    '--cloud-noise 0.02 --cloud-holes 0.2 --cloud-offset 0.05 --cloud-tilt 0.03 --cloud-own 300' '--align'
  trial 'bare ground, `--percentile 15`' '' '--percentile 15'
  cat <<'TEXT'

The largest errors are in three kinds of bins. They hold only the robot's own points, one side of a step, or a wall of more than 0.35 m. The
bands are too wide on smooth clouds. The scatter of the alignment also has the error of the measured pitch. A real map has errors that these
clouds do not have. These are drift of the poses, double walls, beams that graze the ground, and ground that gave way. Measure yours: on a
flat floor all bins of a scene should be equal.
TEXT
} >"$page"
cp "$page" truth.md
