#!/bin/sh
# Records resources/sessions/demo.tts again. The console runs on its simulated robot, driven by keys like an operator's:
# arm, drive up to the step, explore, approve the proposed probe, wait for the arm, drive on. Takes two minutes on an
# idle machine. Needs xvfb and xdotool.
#   docs/demo_session.sh
set -eu
cd "$(dirname "$0")/.."
[ "${1:-}" = inside ] || exec xvfb-run -a -s '-screen 0 1440x900x24' "$0" inside
folder=$(mktemp -d)
trap 'kill "$console" 2>/dev/null || true; rm -rf "$folder"' EXIT
# Runs in the folder of its files, because a session stores the model's path as given.
(cd resources && exec ../build/release/app/terratact-console --model models/default.ttm --safe-mode --language en \
  --size 1440x900 --sessions "$folder") &
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
hold w 3.1
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
build/release/app/terratact session verify "$folder"/*.tts
mkdir -p resources/sessions
cp "$folder"/*.tts resources/sessions/demo.tts
build/release/app/terratact session info resources/sessions/demo.tts
