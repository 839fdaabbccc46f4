#!/bin/sh
# Records resources/sessions/two_tracks.tts again. The console runs on its simulated robot. The ground has a cross slope
# of 4 degrees and a kerb of 0.15 m on the left side. Keys drive it like an operator's: arm, drive up to the kerb,
# explore, approve the proposed probe of a side, wait for the arm, drive on. Takes two minutes on an idle machine. Needs
# xvfb and xdotool.
#   resources/sessions/make_two_tracks.sh
set -eu
cd "$(dirname "$0")/../.."
. resources/sessions/console_session.sh
write_ground 0.0699 1.8
start_console --terrain "$folder/ground.csv"
arm
hold w 2.8
sleep 1
press k
press a
sleep 5
hold space 2.2
sleep 60  # the arm moves, measures, and the second estimate is ready
hold w 2.5
sleep 1
keep two_tracks.tts
