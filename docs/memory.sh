#!/bin/sh
# Writes docs/memory.md: estimates with the memory of the way, against those of one scene alone. Minutes on two cores.
# Usage: docs/memory.sh path/to/terratact LONG_PROFILES.csv TRACK_PAIRS.csv TESTS [DRIVES]
#   LONG_PROFILES.csv, TRACK_PAIRS.csv   real ground of one plane and of two tracks
#   TESTS                                folder of the test programs, build/release/tests
#   DRIVES                               most drives of each file, default 400
set -eu
terratact=$(realpath "$1")
profiles=$(realpath "$2")
pairs=$(realpath "$3")
tests=$(realpath "$4")
drives=${5:-400}
cd "$(dirname "$0")"
docs=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$profiles" long_profiles.csv
ln -s "$pairs" track_pairs.csv
page=$folder/memory.md
OPENBLAS_NUM_THREADS=1
export OPENBLAS_NUM_THREADS

# Evaluates the simulated drives with these options, and prints the command with the table.
evaluate() {
  {
    echo "    terratact evaluate --drives drives.csv${*:+ $*}"
    echo
    echo '```'
    "$terratact" evaluate --drives drives.csv "$@"
    echo '```'
  } >>"$page"
}

# Simulates drives, evaluates them, and prints both commands with the table.
show() {
  "$terratact" simulate "$@" --exact-truth --seed 5 --out drives.csv >/dev/null
  printf '\n    terratact simulate %s --exact-truth --seed 5 --out drives.csv\n' "$*" >>"$page"
  evaluate
}

# Simulates drives into a file, and prints the command.
record() {
  echo "    terratact simulate $*" >>"$page"
  "$terratact" simulate "$@" >/dev/null
}

# Simulates a few drives over generated ground for the smoother, which takes long: so many, spacing, seed, file.
few() {
  record --drives "$1" --terrain varied --spacing "$2" --exact-truth --seed "$3" --out "$4"
}

# Runs a program of the folder TESTS, and prints its command and its output.
bench() {
  program=$1
  shift
  {
    echo "    $program $*"
    echo
    echo '```'
    "$tests/$program" "$@"
    echo '```'
  } >>"$page"
}

# Prints the errors with full presses and with light ones every 5 cm. Networks that learnt from light ones also estimate
# them.
press_often() {
  often='--terrain long_profiles.csv --spacing 0.05'
  show --drives "$drives" $often
  echo >>"$page"
  record --drives 600 --terrain varied --soft-drives 0.3 --spacing 0.05 --press-torque 4 --exact-truth --seed 8 --out light.csv
  echo '    terratact train --drives light.csv --seed 1 --out light.ttn' >>"$page"
  "$terratact" train --drives light.csv --seed 1 --out light.ttn >/dev/null
  show --drives "$drives" $often --press-torque 4
  echo >>"$page"
  evaluate --trail light.ttn
}

# Prints the errors of the smoother, of local and of trail on the same drives.
smooth() {
  few 3 0.3 6 choice.csv
  few 8 0.3 5 drives_0.3.csv
  few 8 0.1 5 drives_0.1.csv
  bench terratact-bench-smoother 150 choice.csv drives_0.3.csv drives_0.1.csv
}

# Prints the errors of processes with the history as features on the smoother's drives and on real ground.
relate() {
  record --drives 400 --terrain varied --soft-drives 0.3 --exact-truth --seed 7 --out training.csv
  record --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --exact-truth --seed 5 --out real_0.3.csv
  record --drives "$drives" --terrain long_profiles.csv --spacing 0.1 --exact-truth --seed 5 --out real_0.1.csv
  bench terratact-bench-history 600 training.csv choice.csv drives_0.3.csv drives_0.1.csv real_0.3.csv real_0.1.csv
}

cat >"$page" <<'TEXT'
# Memory of the way

Ground under the body was under the front flippers a moment ago. The pitch along the way is a profile of the ground under the tracks. The
method `trail` estimates a scene from its readings and from that memory. `core/trail` holds it.

- **Record** (`trail_record.h`): it covers the last 3 m. It holds the attitude and the robot's lower envelope every 2 cm of way. It also
  holds the forces of every press. Dead reckoning places them. A tight turn, a second without telemetry or a jump of the odometry empties
  it.
- **History** (`trail_history.h`): what the record holds at a scene. It has pitch and roll at ten places behind the robot. For each bin it
  has the lowest place of the robot that passed above it. It also has the load and height of the force elements that pressed near it.
- **Ways back**: networks know ways forward alone. Where the robot drives back, the record drops what it learnt at the places ahead, except
  the arm's readings. With them, bands of felt bins covered only 50 to 70 % while reversing: the truth lay above.
- **Felt earlier**: the history also holds which tenths of a bin the flippers pressed from an earlier pose. It also holds the heights that
  the arm measured. A bin that earlier and present presses cover is *remembered*. Under three conditions it counts as felt for the verdict's
  horizon. Dead reckoning adds at most 30 mm to its height. The robot has not turned aside by half a flipper's width. An element ahead
  carries load now. One sd of slip is taken from both ends of each stretch. A suspected sensor ends it, and a robot without a heading
  remembers nothing felt. An arm's reading moves its new bin, but does not make it felt. A fall may begin beside the point that the arm
  touched.
- **Networks** (`trail_model.h`): the mean of a few small networks predicts the eleven bins in the surface coordinate of `local`. They learn from
  simulated drives, some with a cut memory. One set serves a plane; another one serves both sides of two tracks by mirroring.
- **Errors**: every tenth drive is kept from the networks. The 60 scenes with the most similar predictions give the bands, and the correlation of
  bins and sides. Each drive gives one of them. The errors along a drive are nearly one error, and more of them would make bands too narrow. The
  mean error of these scenes does not correct the prediction.
- **Their expected size**: a linear layer predicts the logarithm of a bin's error. It takes the networks' inputs and how much the networks
  differ. The errors of similar scenes are scaled by it. So bands narrow where many presses are remembered, and widen where little is.

Probes and hazards act as in `local`. A scene without a history, or without a current or a force, is estimated by `local`. A warning says
so. What the arm measured earlier then still counts. Ground felt earlier does not, because the networks alone know its height. Where the
robot presses again in place, the arm's readings count as those of the new scene. `terratact train --drives` trains networks;
`resources/models/make_trail.sh` made the shipped ones.

The console uses `trail` by default where the way before a scene is known; otherwise `local` estimates. The line above the picture says how
much is remembered, such as "memory: 1.20 m · earlier presses: 4". Else it says why nothing is remembered: the way begins there, no
odometry, lost telemetry, a turn, or cleared ground. Other causes are a suspected odometry or pitch, a missing current or force, or a model
without networks. The networks are the file beside the model, with the ending `.ttn`. The shipped ones serve robots with Absolem's shape.
Sessions record the history of each scene ([sessions.md](sessions.md#memory-of-the-way)). The review and `session what-if` repeat the
estimates bit for bit. `evaluate --drives` compares both methods. `terratact strip --method trail` scores what was said along drives against
later touches ([strip.md](strip.md#whether-its-bands-hold)).

`docs/memory.sh` made this page. Errors are |median - truth| in mm. Of two tracks, both sides count. No constant was chosen on real ground.

## Real ground, one plane

TEXT
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3
show --drives "$drives" --terrain long_profiles.csv --spacing 0.1
printf '\n## Real ground, two tracks\n' >>"$page"
show --drives "$drives" --terrain track_pairs.csv --tracks --spacing 0.3
show --drives "$drives" --terrain track_pairs.csv --tracks --spacing 0.1
printf '\n## Generated ground\n' >>"$page"
show --drives 150 --terrain varied --soft-drives 0.3
show --drives 150 --terrain varied --soft-drives 0.3 --tracks
printf '\n## Worse odometry, IMU and telemetry\n\nThe first drives have a slip of 20 %% instead of 10 %%. The second have a slip of 10 %% per stretch and 10 %% common to the drive. The\nthird have a pitch that reads 1 degree too much. The fourth have no press at every other stop. The fifth lose half a second of telemetry\nonce per drive, the sixth 1.2 s.\n' >>"$page"
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --slip 0.2
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --drive-slip 0.1
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --pitch-bias 1
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --press-share 0.5
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --gap 0.5
show --drives "$drives" --terrain long_profiles.csv --spacing 0.3 --gap 1.2
cat >>"$page" <<'TEXT'

## Light presses every 5 cm

A robot could press lightly while it drives, instead of stopping for a full press. The other drives of this page press with 12 to 24 N m
of both front flippers together. A light press has 4 N m here. The robot file allows twice its `max_torque_nm`, which is more. The ground
is that of the first section.

The first table has full presses every 5 cm, the others have light ones. The shipped networks learnt from full presses alone. Other
networks therefore learn from light presses here, on generated ground and from fewer drives. The last table is theirs.
TEXT
press_often
cat >>"$page" <<'TEXT'

Compare these tables with both tables of the first section: full presses every 0.3 m and every 0.1 m. The rows `local` are without memory
and the rows `trail` with it. Two conditions decide whether light presses pay, both for `trail` in the last table. Its errors are smaller
than with full presses every 0.1 m. Its bands cover 80 % as well. The first table shows what the spacing gives alone. The last two tables
differ in the networks alone. The processes of `local` learnt from full presses in all tables.

The tables do not contain the pace. In the simulation the robot stands for each press, and its front flippers are up between two presses.
Flippers that drag over the ground are not simulated. Neither the console nor its simulated robot presses while it drives.

## Size of the record

A test fills a record with a line of telemetry every millimetre. At each of its places it adds a press, and a reading of the arm for each
bin in reach. The limit is 1 MB:

    core.trail --gtest_filter='*OneMegabyte'

```
TEXT
"$tests/core.trail" --gtest_filter='*OneMegabyte' | grep '^record of' >>"$page"
cat >>"$page" <<'TEXT'
```

## A smoother over the drive

The networks were compared with a filter that learns nothing: an ensemble Kalman smoother (`tests/bench/drive_ensemble.h`). Each of its 150
members is a ground with posts every 0.05 m, and the robot's place on it. The members begin as random pieces of generated ground. Odometry
moves the robot on each member, with a slip of its own. At each press, the rest pose on each member predicts the readings. So it does after
every 0.12 m of way without a press, for pitch and currents.

The differences to the measured readings then correct each member. They correct its ground behind and ahead, the robot's place, and the
heights of the bins. The readings have the noise of the simulated sensors, and that of ground through posts. *Reach* localises:
corrections of the ground fall with the distance from the robot. *Relaxation* inflates: it is the share of the spread before an update
that is kept. Both are chosen on drives of another seed, for the least mean error.

The smoother knows that the ground is hard, the robot's shape and weight, and the range of press torques. Its heights are those after
the press of their scene, as of the other methods. Its CPU time is that of the way since the last stop and of the press. Few drives are
judged because of it. Every method sees the same drives, so compare the rows of a table.

TEXT
smooth
cat >>"$page" <<'TEXT'

## The history as features of the processes of local

The method `local` has two Gaussian processes for each bin: one where the robot covers it, and one elsewhere. They know the scene's 11
features. Here they also get 38 features of the history (`tests/bench/drive_history.cpp`). These are inputs of the networks, too:

- *pitch*: at ten places behind the robot along the way.
- *passed*: how far the lowest place of the robot that passed above a bin lies under the present robot.
- *load*, *pressed*: load of the force elements that pressed near a bin earlier, and their distance below the robot. Odometry
  carries them.
- *way*: the length of the memory.

The relevance search gives each input of each process a length scale of its own. The scales maximise the marginal likelihood of at most 600
scenes of the training drives. The relevance is 1 / length scale, in standardised inputs. The list has its mean over the bins -0.3 ... 0.5 m,
of the process with more scenes. Then each process keeps its most relevant inputs alone, and the search is repeated. Their number is chosen
on the drives that chose for the smoother, for the least mean error.

All scenes of the training drives give the weights, through at most 600 inducing rows as in `local`. Bands come from the errors of training
scenes, each predicted without its own drive. The rows *scene* are of the same processes with the scene's features alone. The rows *history*
are of those with the chosen inputs. Their CPU time is without that of the history. The shipped networks have learnt from more drives.

TEXT
relate
cp "$page" "$docs/memory.md"
