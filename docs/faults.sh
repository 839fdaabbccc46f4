#!/bin/sh
# Writes docs/faults.md: which sensor faults are detected, and their effect. Takes about ten minutes on two cores.
# Usage: docs/faults.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
cat >"$page" <<'EOF'
# Sensors that lie

The console watches every line of telemetry for readings that cannot be true (`core/robot/watch/sensor_watch.h`). While one is suspected, no
verdict is given, and an alarm names the sensor and the kind. The table was printed by the command above it, and this page by
`docs/faults.sh`. A fault begins with the drive and lasts.

- *mean mm*, *in 80*: mean |error| and share of the truth in the 80 % bands of all scenes, method `local`.
- *suspect*: scenes [%] that the watch suspects. *contra*: scenes [%] whose estimate contradicts the readings. *doubt*: scenes [%] with any doubt, this one or another: their verdict is withheld.
- *drives*: drives [%] in which the watch suspects something. *after s*, *scenes*: the median time and scenes until then.
- *left mm*, *in 80*: error and cover of the scenes without a doubt.

A fault harms where it adds more than 5 mm to the mean error or takes more than 10 points from the cover; it counts as noticed where 90 %
of the scenes are in doubt, or 90 % of the drives suspected.

To practise: `terratact-console --fault stuck:pitch@20`. To record scenes: `terratact simulate --disturb late:front`. Every kind and sensor:
FAULTS in `man terratact`.

    terratact faults --drives 40 --seed 1

EOF
table() {
  echo '```'
  "$terratact" faults --drives 40 --seed 1 "$@" 2>/dev/null
  echo '```'
}
table >>"$page"
cat >>"$page" <<'EOF'

A tilt of the IMU agrees with everything else in one direction. So the same is driven there and back: the robot turns on the spot at the
end of its way, and returns over the same ground. A drive that comes back less than 3 m is left out, because the robot got stuck or tipped
over on its way. The ground's slope changes its sign there, and a shift of the pitch does not. A shift is thus noticed at the end of the drive,
not in each scene: after 2.5 m back or more. A robot that backs up over its ground, without a turn, sees the same slope again, and notices
nothing.

    terratact faults --drives 40 --seed 1 --return

EOF
table --return >>"$page"
cat >>"$page" <<'EOF'

## Every kind at every sensor

Drives [%] with any suspicion, without estimates; a letter says why a fault is not noticed in every drive. Some drives raise a suspicion
without a fault, too: the row *none* above says how many. The watch reads each of the twelve elements: *force-1* is element 1 of both sides,
*left-force-1* that of the left side alone. In the simulation both sides feel the same ground. `terratact simulate --disturb` records scenes,
which have the mean of both sides: a fault of one side is half as large in them.

    terratact faults --matrix --drives 10 --seed 1

EOF
{
  echo '```'
  "$terratact" faults --matrix --drives 10 --seed 1 2>/dev/null
  echo '```'
} >>"$page"
mv "$page" faults.md
chmod 644 faults.md
