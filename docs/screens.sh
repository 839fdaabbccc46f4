#!/bin/sh
# Makes the pictures of the README and of docs/manual.md again from a release build. They show the console on its
# simulated robot, the review of the shipped session, and nine states of tests/app/console/screens_test.cpp. Needs
# imagemagick to make the files smaller.
#   docs/screens.sh
set -eu
cd "$(dirname "$0")/.."
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8

small() { convert "$1" +dither -colors 200 -strip "$2"; }

build/release/app/terratact-console --screenshot "$all/console.png"
build/release/app/terratact-console resources/sessions/demo.tts --at 66 --screenshot "$all/review.png"
TERRATACT_LANGUAGE=en TERRATACT_PICTURES="$all" build/release/tests/app.console.screens_test \
  --gtest_filter=Screens.start:Screens.verdict:Screens.probe:Screens.result:Screens.trouble:Screens.lying
mkdir -p docs/screens
small "$all/console.png" docs/console.png
small "$all/review.png" docs/screens/review.png
small "$all"/??-??_not_armed.png docs/screens/start.png
small "$all"/??-??_draws_second_method_and_a_bin_up_close.png docs/screens/draws.png
small "$all"/??-??_probed.png docs/screens/probed.png
small "$all"/??-??_page_signals.png docs/screens/signals.png
small "$all"/??-??_alarms_of_a_lost_link.png docs/screens/alarms.png
small "$all"/??-??_clear_to_a_horizon.png docs/screens/clear.png
small "$all"/??-??_proposed.png docs/screens/cannot_tell.png
small "$all"/??-??_attitude_alarm.png docs/screens/attitude.png
small "$all"/??-??_stuck_imu.png docs/screens/stuck_imu.png
