#!/bin/sh
# Writes docs/strip.md: the strip of felt ground and its errors.
# Usage: docs/strip.sh path/to/terratact [DRIVES]
#   DRIVES   simulated drives, default 60: half a minute on two cores
set -eu
terratact=$(realpath "$1")
drives=${2:-60}
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  cat <<'TEXT'
# The strip of felt ground

The robot keeps what it felt along its way. The strip holds the ground in bins of 0.1 m, left and right. Each bin has a height, its 80 %
band and the time of its scene. It also states how the bin was felt: *arm*, *contact*, *track* or *in part*. At a *contact* a front flipper
pressed on the whole bin. The bin is *bounded* if the robot was above it and did not press, else *not felt*. `core/strip/strip.h` is the
contract.

## How it is built

Telemetry reports how far the tracks rolled and how much the robot turned. The frame is Odometry ([can.md](can.md));
`core/robot/measurement.h` holds it as `travelled` and `turned`. The frame is optional; without it there is no strip.
`core/strip/dead_reckoning.h` adds up the steps along the pitch. Its errors have four reasons:

- The tracks slip. The sd is `travelled_sd_share` of the way, times the difference between the ground's slope and the robot's own. The
  share is in the robot file: 10 % for Absolem, an assumption.
- The pitch has an sd of `pitch_sd_rad`, over the way.
- Where the pitch changes, the robot turns about an unknown point of its tracks between the axles.
- Where the roll changes, it turns about an unknown point between its tracks.

The last digit of a standing robot's odometry may flicker. A step against the last one counts from more than 2 mm on.

Every finished estimate is entered at the pose of its scene. First, the ground that it shares with the strip corrects the odometry since the
scene before (`core/strip/strip_match.h`). The errors of successive estimates are one error, so each bin counts as half an independent one.
Then the newer estimate replaces the older one, with two exceptions. Ground that was felt stays where the newer estimate did not feel it and is
less certain. Ground that is not felt never replaces more certain ground. The sd grows with the way since the bin was felt.

A new section begins, and nothing is joined over its begin, when one of these happens:

- the robot turns by more than 0.1 rad within 0.3 m;
- no telemetry comes for a second;
- the reported way jumps between two lines. A jump is more than 1 m, or more than 0.15 m at more than 1.5 m/s;
- there is no odometry, or the odometry or the pitch is suspected. Then nothing is entered;
- the operator clears the ground, or another model is loaded.

The strip keeps the last 150 m of ground, with less than 1 MB.

## Whether its bands hold

Ground that is touched again scores the strip's earlier heights (`core/strip/strip_ledger.h`). The band is seen from the new pose by
odometry alone, and widened by the touch's own sd. So the scene that judges changes neither the band nor the pose.

- *contact*: a front flipper's element at a later scene. Its height follows from the scene's angles and forces alone, with an sd of 20 mm.
- *pass*: the tracks stand there at a later scene. Height and sd are that scene's estimate. By `trail`, it knows earlier readings as well.
- *probe*: the arm. It scores the band that was shown in its scene before.

A scene counts once. On two tracks, the tracks do not score heights of the flippers' line. The console's line above the picture states
how many bands held, such as "bands held: 83 of 100". `terratact session strip` prints it by kind of touch for a session.

## On the screen

The terrain picture draws remembered ground behind, under and ahead of the robot, in the console and in a review. It is a dashed line in a
band without marks, dotted where the ground was bounded or felt in part. Its standard deviation stands beside it. While an estimate stands,
only the ground behind it is drawn. Ground that was not felt is not drawn, nor ground with an sd above 0.15 m. Remembered ground decides
nothing: the verdict is *NO VERDICT* until the next estimate. The wheel zooms, dragging moves the window, a double click shows the robot
again. Behind the strip stand up to eight sections from before a break, thin and grey. Each lies behind a gap with a dashed rule and the
reason. They have no known place relative to the robot. A review shows the same strip. It reads a long session from its begin while it is
open. Until it has reached the shown moment, ground felt 10 to 15 min before it, or earlier, is missing.

![Remembered ground behind the robot, under it and ahead of it](screens/strip_live.png)

The same drive after 5 m, zoomed out:

![The whole strip of a drive of 5 m behind the robot](screens/strip_zoomed_out.png)

## Export

`terratact session strip drive.tts --out strip.csv` writes a line for each bin and side:

| column | meaning |
| --- | --- |
| `section`, `start` | number of the section, and why it begins |
| `side`, `one_plane` | left or right; 1 if the estimate was of one plane, so both sides are equal |
| `x_m` | centre of the bin along the way, from the IMU of the section's first scene |
| `plan_x_m`, `plan_y_m` | the same from above: forward and left. It is on the line of the track, or of the flipper from +0.3 m on |
| `height_m`, `sd_m`, `q10_m`, `q90_m` | height above that IMU, as certain as when it was felt |
| `drift_sd_m` | sd of the height by the way since the section's begin |
| `felt` | how it was felt |
| `time_s`, `estimate` | time of the scene since the session's begin, and number of the estimate |

`--out strip.ply` writes a point cloud, PLY in ASCII. Each vertex has `float x y z` in metres, which CloudCompare, MeshLab, PCL and RViz (by
PCL) expect, with z up. `sd`, `time`, `side` (0 left, 1 right), `felt` (0 arm to 6 not recorded) and `section` are further properties.
The strip does not hold the offset between two sections. The cloud therefore lays them 1 m apart along x. `--section 2` writes one
section in its own frame.

`--out strip.svg`, `.png`, `.pdf` or `.html` draws both sides with their 80 % bands. Each piece has 6 m, equal axes and a scale. The sides
differ by line and band: the right one is dashed and hollow. Marks show how a bin was felt, filled ones by touch. A bracket marks the newest
estimate; all else is remembered. An SVG keeps the columns above in its `<metadata>`. This is the strip of a drive by
[feel forward](manual.md#feel-forward), from the session `feel_forward.tts` that the program ships:

![Heights of a drive over level ground up to a kerb on the left, with 80 % bands](screens/strip_exported.png)

The console writes the same files: *View > Export the strip of felt ground …* of the strip as it is now. A review writes that of the whole
session by its export dialog.

## What it is worth

TEXT
  echo 'Simulated drives over random ground, with slip of 10 % and pitch noise of 0.5°. After each scene, all bins of the strip are compared with the'
  echo 'true ground as seen from the true pose. `docs/strip.sh` made this page:'
  for spacing in 0.3 0.1; do
    echo
    echo "    terratact strip --drives $drives --spacing $spacing"
    echo
    echo '```'
    "$terratact" strip --drives "$drives" --spacing "$spacing"
    echo '```'
  done
  echo
  echo 'By `trail`, the ledger alone:'
  echo
  echo "    terratact strip --drives $drives --spacing 0.1 --method trail"
  echo
  echo '```'
  "$terratact" strip --drives "$drives" --spacing 0.1 --method trail | sed -n '/^later/,$p'
  echo '```'
  cat <<'TEXT'

The last table compares the ledger with the truth. *in 80%* is the share of touches within the widened bands. *truth* is the share of true
heights within the bands. A console has no truth; its ledger stands for it.

Errors are in mm, *width* is that of the 80 % band. The rule and the weight of shared ground were chosen on such drives. The strip decides nothing:
the verdict rests on the estimate of the present scene.

Behind the robot, the errors come from the way. A bin that is entered 0.1 m too far is wrong by the whole height of a step. The trial does
not cover turns, slip that is not a share of the way, soft ground, or real odometry.
TEXT
} >"$page"
cp "$page" strip.md
