#!/bin/sh
# Writes docs/faults.md: which sensor faults are detected, and their effect. Takes about ten minutes on two cores.
# Usage: docs/faults.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
cat >"$page" <<'EOF'
# Sensor faults

The console checks every line of telemetry for readings that cannot be true (`core/robot/watch/sensor_watch.h`). While a sensor is
suspected, no verdict is given, and an alarm names the sensor and the kind of fault. The command above each table printed the table;
`docs/faults.sh` made this page. A fault begins with the drive and lasts.

- *mean mm*, *in 80*: mean |error| and share of the truth in the 80 % bands of all scenes, method `local`.
- *suspect*: scenes [%] that the watch suspects. *contra*: scenes [%] whose estimate contradicts the readings. *doubt*: scenes [%] with any doubt, whose verdict is withheld.
- *drives*: drives [%] in which the watch suspects something. *after s*, *scenes*: the median time and scenes until then.
- *left mm*, *in 80*: error and cover of the scenes without a doubt.

A fault is harmful if it adds more than 5 mm to the mean error. It is also harmful if it takes more than 10 points from the cover. It counts
as noticed where 90 % of the scenes are in doubt, or 90 % of the drives suspected.

To practise: `terratact-console --fault stuck:pitch@20`. To record scenes: `terratact simulate --disturb late:front`. Every kind and sensor:
FAULTS in `man terratact`. A lost sensor, as in `--fault lost:front-left-current@20`, is not suspected: telemetry says
what is missing, and so does the estimate.

    terratact faults --drives 40 --seed 1

EOF
table() {
  echo '```'
  "$terratact" faults --drives 40 --seed 1 "$@" 2>/dev/null
  echo '```'
}
table >>"$page"
cat >>"$page" <<'EOF'

In one direction, a tilt of the IMU agrees with every other reading. In this trial the robot therefore turns on the spot at the end of its
way. It returns over the same ground. The slope of the ground then changes its sign; a shift of the pitch does not. The shift is noticed at
the end of the drive, not in each scene: after 2.5 m back or more. A robot that backs up without a turn measures the same slope again, and
notices nothing. Drives that come back less than 3 m are left out: the robot got stuck or tipped over.

    terratact faults --drives 40 --seed 1 --return

EOF
table --return >>"$page"
cat >>"$page" <<'EOF'

## Every kind at every sensor

The table shows drives [%] with any suspicion, without estimates. A letter gives the reason why the fault is hard to notice, or impossible.
A cell below 100 without a letter has another reason: the drive was too short. In such a drive the robot got stuck or tipped over. The
rules need some way and several presses before they judge. `--return` leaves out such drives. Some drives raise a suspicion without a fault,
too: the row *none* above shows how many. The watch reads each of the twelve elements. *force-1* is element 1 of both sides, *left-force-1*
that of the left side alone. In the simulation both sides feel the same ground. `terratact simulate --disturb` records scenes with the mean
of both sides: there a fault of one side is half as large.

    terratact faults --matrix --drives 10 --seed 1

EOF
{
  echo '```'
  "$terratact" faults --matrix --drives 10 --seed 1 2>/dev/null
  echo '```'
} >>"$page"
mv "$page" faults.md
chmod 644 faults.md
