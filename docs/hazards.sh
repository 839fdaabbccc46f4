#!/bin/sh
# Writes docs/hazards.md: how often the verdict is wrong before hazards that no model is trained on.
# Usage: docs/hazards.sh path/to/terratact [DRIVES]
#   DRIVES   number per kind of hazard and ground, default 40: about five minutes on two cores
set -eu
terratact=$(realpath "$1")
drives=${2:-40}
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  echo '# The verdict before hazards'
  echo
  echo 'Simulated drives, a scene every 0.1 m, towards drops, gaps, pits, ditches, ramps that end, walls and lips of 0.15 to 2 m'
  echo '(`core/sim/hazard_terrain.h`). No model is trained on them. The ground before and after them is level, or has the'
  echo 'roughness of ISO 8608 class A or C. Press torques are random, 12 to 24 N m. Made by `docs/hazards.sh`:'
  echo
  echo "    terratact hazards --drives $drives"
  echo
  echo '```'
  "$terratact" hazards --drives "$drives"
  echo '```'
  echo
  echo 'What remains at the default rate are gaps whose far edge lies within 0.02 m of the pivot, where the first element loses less load than its'
  echo 'noise, and slots of less than 0.05 m. On rough ground only the tips press, so that CLEAR needs a probe or a lower rate.'
} >"$page"
cp "$page" hazards.md
