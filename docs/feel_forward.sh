#!/bin/sh
# Writes docs/feel_forward.md: how far and how fast feel forward goes, and whether it falls.
# Usage: docs/feel_forward.sh path/to/terratact [DRIVES]
#   DRIVES   default 50: less than a minute on two cores
set -eu
terratact=$(realpath "$1")
drives=${2:-50}
cd "$(dirname "$0")"
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  echo '# Feel forward'
  echo
  echo 'Feel forward is Algorithm 1 of the paper as a loop: halt, press, estimate, advance 0.1 m, again. It continues while the operator holds a'
  echo 'dead-man control and the verdict is CLEAR beyond the next advance ([manual.md](manual.md#feel-forward)). The state machine is'
  echo '`core/atem/atem_machine.h`, what allows an advance is `core/atem/feel_forward.h`. `docs/feel_forward.sh` made this page:'
  echo
  echo "    terratact feel-forward --drives $drives --method trail"
  echo
  echo 'A simulated robot drives over generated ground towards a hazard of 0.15 to 2 m. Hazards are drops, gaps, pits, ditches, ramps that end,'
  echo 'walls and lips. The ground is level, or has the roughness of ISO 8608 class A or C. It is hard, or soft with a layer of 12 to 28 mm. The'
  echo 'estimates are those of the method trail, the default of the console, with the shipped model. The simulated operator only holds the control.'
  echo 'Where the loop asks on ground that is truly free, the robot is driven on by 0.1 m by hand. Then the operator holds again. So each drive'
  echo 'comes to its hazard, or to the end of the ground. No probe is made.'
  echo
  echo '```'
  "$terratact" feel-forward --drives "$drives" --method trail
  echo '```'
  echo
  echo '## The same without the verdict'
  echo
  echo 'A loop that advances whatever the verdict is shows what the verdict prevents:'
  echo
  echo "    terratact feel-forward --drives $drives --method trail --blind"
  echo
  echo '```'
  "$terratact" feel-forward --drives "$drives" --method trail --blind
  echo '```'
  echo
  echo '## What this means'
  echo
  echo '- The loop goes on by itself on level ground. A whole round takes about 4.5 s, which is 1.3 m/min. Most of it goes into the flippers, up for'
  echo '  each advance and down for each press. The pace in the table is less: it includes the presses after which the loop asks. A fit of the rows'
  echo '  of the table gives 1.9 s for a press with its estimate. Raising and advancing take 2.6 s. Of 577 presses, 417 ended a loop. They take half'
  echo '  of the time of all loops, so fewer questions, not shorter waits, would raise the pace.'
  echo '- On hard rough ground it asks at nearly every stop. The flippers rest there on one or two points, so the ground between them is only'
  echo '  bounded. The operator then drives by hand, or asks for a probe. The method trail has smaller errors there, and counts what'
  echo '  was felt at earlier stops. But single points feel little ground.'
  echo '- The simulated robot raises its front flippers to 1.2 rad before an advance. Their tips then come no further ahead than those of flat'
  echo '  flippers before it. A robot that raises them less reaches further.'
  echo '- A *touch* is an advance in which a front flipper met ground above the step limit. The limit counts from the ground under the foremost'
  echo '  wheels. CLEAR must reach beyond the advance of the tracks, not as far as the tips. So a flipper can still meet a wall that nobody has'
  echo '  felt. A touch is no collision, because collisions count only rises that the tracks meet. The drive goes on after a touch.'
  echo '- The simulation has no sensor faults, no lost telemetry and no slide. The odometry has a slip of 10 %. Faults of the loop itself are'
  echo '  tested in `tests/core/atem/feel_forward_test.cpp`, with a row for each transition.'
} >"$page"
cp "$page" feel_forward.md
