#!/bin/sh
# Records resources/sessions/demo.tts again. The console runs on its simulated robot, driven by keys like an operator's:
# arm, drive up to the step, explore, approve the proposed probe, wait for the arm, drive on. Takes two minutes on an
# idle machine. Needs xvfb and xdotool.
#   docs/demo_session.sh
set -eu
cd "$(dirname "$0")/.."
. resources/sessions/console_session.sh
start_console
arm
hold w 3.1
sleep 1
press k
press a
sleep 5
hold space 2.2
sleep 60  # the arm moves, measures, and the second estimate is ready
hold w 2.5
sleep 1
keep demo.tts
