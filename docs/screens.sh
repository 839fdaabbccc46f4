#!/bin/sh
# Makes the pictures of the README and of docs/manual.md anew from a release build: the console on its built-in robot,
# the review of the shipped session, and five of the states that tests/app/screens_test.cpp walks through.  Wants
# imagemagick, to make the files smaller.
#   docs/screens.sh
set -eu
cd "$(dirname "$0")/.."
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8

small() { convert "$1" +dither -colors 200 -strip "$2"; }

build/release/app/terratact-console --screenshot "$all/console.png"
build/release/app/terratact-console resources/sessions/demo.tts --at 66 --screenshot "$all/review.png"
TERRATACT_PICTURES="$all" build/release/tests/app.screens_test --gtest_filter='*/0'  # in English
mkdir -p docs/screens
small "$all/console.png" docs/console.png
small "$all/review.png" docs/screens/review.png
small "$all/02_not_armed.png" docs/screens/start.png
small "$all/08_draws_second_method_and_a_bin_up_close.png" docs/screens/draws.png
small "$all/11_probed.png" docs/screens/probed.png
small "$all/23_page_Signals.png" docs/screens/signals.png
small "$all/14_alarms_of_a_lost_link.png" docs/screens/alarms.png
