#!/bin/sh
# Writes docs/hazards.md: how often the verdict is wrong before hazards that no model is trained on.
# Usage: docs/hazards.sh path/to/terratact [DRIVES]
#   DRIVES   number per kind of hazard and ground, default 12: about three minutes on two cores
set -eu
terratact=$(realpath "$1")
drives=${2:-12}
rates=0.01,0.05
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  echo '# The verdict before hazards'
  echo
  echo 'Simulated drives, a scene every 0.1 m, towards drops, gaps, pits, ditches, ramps that end, walls and lips of 0.15 to 2 m'
  echo '(`core/sim/hazard_terrain.h`). No model is trained on them. The ground before and after them is level, or has the'
  echo 'roughness of ISO 8608 class A or C. It is hard, or soft with a layer of 12 to 28 mm. Made by `docs/hazards.sh`:'
  echo
  echo "    terratact hazards --drives $drives --rates $rates"
  echo
  echo '```'
  "$terratact" hazards --drives "$drives" --rates "$rates"
  echo '```'
  echo
  echo 'What remains at the default rate are gaps whose far edge lies within 0.02 m of the pivot, where the first element loses less load than its'
  echo 'noise, falls that begin within the last 0.02 m before the horizon, and slots of less than 0.05 m.'
  echo
  echo 'On hard rough ground the robot rests on single points (*press* is 0 there). Between them nothing is felt, and the readings seldom tell flat'
  echo 'ground from a gap that the flippers span: CLEAR needs a probe or a lower rate, and a lower rate costs what the tables show.'
} >"$page"
cp "$page" hazards.md
