#!/bin/sh
# Makes the pictures of the README, of docs/manual.md and of docs/strip.md again from a release build. They show the
# console on its simulated robot, also on ground that differs left and right. They also show the review of the shipped
# session and the strip of another one. Nine states come from tests/app/console/screens/screens_test.cpp, and two of a
# drive of 5 m from tests/app/console/strip_console_test.cpp. Needs imagemagick to make the files smaller.
#   docs/screens.sh
set -eu
cd "$(dirname "$0")/.."
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8

# lines KIND: ground under each flipper and track that differs left and right (docs/files.md).
lines() {
  awk -v kind="$1" 'BEGIN {
    print "step_m,y_m,heights_m"
    n = split("0.272 0.1985 -0.1985 -0.272", ys)
    for (k = 1; k <= n; ++k) {
      y = ys[k]
      printf "0.01,%s", y
      for (i = 0; i <= 1500; ++i) {
        x = 0.01 * i
        z = 0
        if (kind == "kerb") z = y > 0 && x >= 1.8 ? 0.2 : 0
        if (kind == "diagonal") z = x + 0.7 * y >= 2.0 ? 0.15 : 0
        if (kind == "slope") z = 0.17 * y + (x >= 1.9 ? 0.15 : 0)
        if (kind == "hanging") z = y > 0 ? (x < 1.8 ? 0 : 0.2) : x < 1.45 ? 0 : -0.6
        printf ",%.4f", z
      }
      print ""
    }
  }'
}

small() { convert "$1" +dither -colors 200 -strip "$2"; }

build/release/app/terratact-console --screenshot "$all/console.png"
build/release/app/terratact-console resources/sessions/demo.tts --at 66 --screenshot "$all/review.png"
TERRATACT_LANGUAGE=en TERRATACT_PICTURES="$all" build/release/tests/app.console.screens.screens_test \
  --gtest_filter=Screens.start:Screens.verdict:Screens.probe:Screens.result:Screens.trouble:Screens.lying:Screens.gamepad
TERRATACT_PICTURES="$all" build/release/tests/app.console.pages --gtest_filter='*fitInEvery*'
TERRATACT_PICTURES="$all" build/release/tests/app.console.bus --gtest_filter='StripConsole.*'
build/release/app/terratact session strip resources/sessions/feel_forward.tts --out "$all/strip_exported.png"
for kind in level kerb diagonal slope hanging; do
  lines "$kind" >"$all/$kind.csv"
  build/release/app/terratact-console --terrain "$all/$kind.csv" --screenshot "$all/$kind.png"
done
mkdir -p docs/screens
for kind in kerb diagonal slope hanging; do small "$all/$kind.png" "docs/screens/$kind.png"; done
small "$all/console.png" docs/console.png
small "$all/review.png" docs/screens/review.png
small "$all"/??-??_not_armed.png docs/screens/start.png
small "$all"/??-??_draws_second_method_and_a_bin_up_close.png docs/screens/draws.png
small "$all"/??-??_probed.png docs/screens/probed.png
small "$all"/??-??_page_signals.png docs/screens/signals.png
small "$all"/??-??_alarms_of_a_lost_link.png docs/screens/alarms.png
small "$all/level.png" docs/screens/clear.png
small "$all"/??-??_proposed.png docs/screens/cannot_tell.png
small "$all"/??-??_attitude_alarm.png docs/screens/attitude.png
small "$all"/??-??_stuck_imu.png docs/screens/stuck_imu.png
small "$all"/??-??_page_gamepad.png docs/screens/gamepad.png
small "$all/plots_day.png" docs/screens/plots.png
small "$all/strip-live.png" docs/screens/strip_live.png
small "$all/strip-zoomed-out.png" docs/screens/strip_zoomed_out.png
small "$all/strip_exported.png" docs/screens/strip_exported.png
