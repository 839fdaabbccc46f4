#!/bin/sh
# Records resources/sessions/feel_forward.tts again. The console runs on its simulated robot, on level ground. On the
# left side a kerb of 0.15 m is 2.5 m ahead. Keys drive it like an operator's: arm, and hold F until feel forward ends
# by itself and asks. If it asks before it has advanced 12 times, the operator drives on by hand and holds F again. No
# probe is approved. Takes two minutes on an idle machine. Needs xvfb and xdotool.
#   resources/sessions/make_feel_forward.sh
set -eu
cd "$(dirname "$0")/../.."
. resources/sessions/console_session.sh

advances() { count ',phase,advancing,'; }
ends() { count ',word,[a-z]*,"*feel forward has ended after'; }
has_ended_again() { [ "$(ends)" -gt "$before" ]; }

# Holds F until feel forward ends by itself.
feel_forward() {
  before=$(ends)
  xdotool keydown f
  await 300 has_ended_again
  xdotool keyup f
}

write_ground 0 3.2
start_console --terrain "$folder/ground.csv"
arm
feel_forward
while [ "$(advances)" -lt 12 ]; do
  [ "$(ends)" -lt 6 ] || fail "feel forward has ended $(ends) times after $(advances) advances"
  press n  # refuses a probe, if one is proposed
  sleep 1
  hold w 1.5
  sleep 1
  feel_forward
done
sleep 3  # the question stays on the screen
press n
sleep 1

happened ',decision,feel forward,' || fail "no decision to feel forward is recorded"
[ "$(estimates)" -ge 3 ] || fail "only $(estimates) estimates are recorded"
! happened 'feel forward has ended after .*: a fault' || fail "a fault has ended feel forward"
! happened ',decision,approve,' || fail "a probe was approved"
keep feel_forward.tts
