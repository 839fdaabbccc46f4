#!/bin/sh
# Records resources/sessions/two_tracks.tts again. The console runs on its simulated robot, on ground with a cross slope of
# 4 degrees and a kerb of 0.15 m on the left side. Keys drive it like an operator's: arm, drive up to the kerb, explore,
# approve the proposed probe of a side, wait for the arm, drive on. Takes two minutes on an idle machine. Needs xvfb
# and xdotool.
#   resources/sessions/make_two_tracks.sh
set -eu
cd "$(dirname "$0")/../.."
[ "${1:-}" = inside ] || exec xvfb-run -a -s '-screen 0 1440x900x24' "$0" inside
folder=$(mktemp -d)
trap 'kill "$console" 2>/dev/null || true; rm -rf "$folder"' EXIT

# Lines under each track and each flipper (docs/files.md); the robot starts 1.1 m before the kerb.
awk 'BEGIN {
  print "pair,step_m,y_m,heights_m"
  n = split("0.272 0.1985 -0.1985 -0.272", ys)
  for (k = 1; k <= n; ++k) {
    printf "kerb,0.01,%s", ys[k]
    for (i = 0; i <= 500; ++i) printf ",%.4f", 0.0699 * ys[k] + (ys[k] > 0 && i >= 180 ? 0.15 : 0)
    print ""
  }
}' > "$folder/ground.csv"

# Runs in the folder of its files, because a session stores the model's path as given.
(cd resources && exec ../build/release/app/terratact-console --model models/default.ttm --safe-mode --language en \
  --size 1440x900 --terrain "$folder/ground.csv" --sessions "$folder/recorded") &
console=$!

press() { xdotool key "$1"; }
hold() { xdotool keydown "$1"; sleep "$2"; xdotool keyup "$1"; }

sleep 4
window=$(xdotool search --onlyvisible --class terratact | head -n 1)
xdotool windowfocus "$window"
press m
sleep 0.6
hold m 2.5
sleep 0.5
hold w 2.8
sleep 1
press k
press a
sleep 5
hold space 2.2
sleep 60  # the arm moves, measures, and the second estimate is ready
hold w 2.5
sleep 1
kill -TERM "$console"
wait "$console" || true
build/release/app/terratact session verify "$folder"/recorded/*.tts
cp "$folder"/recorded/*.tts resources/sessions/two_tracks.tts
build/release/app/terratact session info resources/sessions/two_tracks.tts
