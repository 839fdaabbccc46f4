#!/bin/sh
# Writes docs/hazards.md: how often the verdict is wrong before hazards that no model is trained on.
# Usage: docs/hazards.sh path/to/terratact [DRIVES [REMEMBERED]]
#   DRIVES       number per kind of hazard and ground, default 12: about five minutes on two cores
#   REMEMBERED   the same with telemetry on the way, default 1: about four minutes more
set -eu
terratact=$(realpath "$1")
drives=${2:-12}
remembered=${3:-1}
rates=0.01,0.05
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  echo '# The verdict before hazards'
  echo
  echo 'A simulated robot drives towards hazards of 0.15 to 2 m, with a scene every 0.1 m. The hazards are drops, gaps, pits, ditches,'
  echo 'ramps that end, walls and lips (`core/sim/ground/hazard_terrain.h`). No model is trained on them. The ground before and after a hazard is'
  echo 'level, or has the roughness of ISO 8608 class A or C. It is hard, or soft with a layer of 12 to 28 mm. `docs/hazards.sh` made this page:'
  echo
  echo "    terratact hazards --drives $drives --rates $rates"
  echo
  echo '```'
  "$terratact" hazards --drives "$drives" --rates "$rates"
  echo '```'
  echo
  echo 'Three hazards remain at the default rate. One is a gap whose far edge lies within 0.02 m of the pivot. There the first element loses less'
  echo 'load than its noise. Another is a fall that begins within the last 0.02 m before the horizon. The third is a slot of less than 0.05 m.'
  echo
  echo 'The first target is at most 1 false CLEAR in 1000 scenes with a step. The second is CLEAR in 70 % of the scenes whose felt ground is'
  echo 'flat (*flat%*). The default rate reaches the first in the total, though not on each kind of soft ground. It reaches the second in few rows:'
  echo 'level ground, the console'"'"'s press, and two tracks or a memory (below). The rate 0.01 reaches the second with many false CLEAR.'
  echo
  echo 'On hard rough ground the robot rests on single points (*press* is 0 there). Between them nothing is felt. The readings seldom distinguish'
  echo 'flat ground from a gap that the flippers span. CLEAR needs a probe or a lower rate. The tables show what a lower rate costs.'
  echo
  echo '## Two tracks'
  echo
  echo 'The same drives over ground of two lines have the hazard on one side or on both. Left and right are estimated and judged:'
  echo
  echo "    terratact hazards --tracks --drives $drives"
  echo
  echo '```'
  "$terratact" hazards --tracks --drives "$drives"
  echo '```'
  echo
  echo '## With the memory of the way'
  echo
  echo 'The console remembers the way before a scene (method *trail*). These drives have telemetry between their scenes. They are judged by'
  echo '*trail*, and the same ones by *local*, which uses the scene alone. Ground that'
  echo 'earlier poses felt counts as felt by *trail*:'
  echo
  echo "    terratact hazards --tracks --memory --drives $remembered"
  echo
  echo 'First come drives that turn, reverse and probe (`manoeuvre_drives.h`). Their ground is known everywhere. A hazard lies across'
  echo 'the way, or beside it, where only a turned robot reaches it with a flipper. The arm touches a point of a bin. What lies between two points,'
  echo 'or a point and felt ground, 0.1 m apart at most, counts as felt. A reading far from the estimate counts by itself.'
  echo
  echo '```'
  "$terratact" hazards --tracks --memory --drives "$remembered"
  echo '```'
} >"$page"
cp "$page" hazards.md
