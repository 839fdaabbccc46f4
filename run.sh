#!/usr/bin/env bash
# Sets up, builds and starts Terratact on the simulated robot with the shipped model:
#   ./run.sh [argument...]              the console; without a display as with --headless
#   ./run.sh --headless [argument...]   no window: one exploration, printed and written to build/demo
# Other arguments are passed on (./run.sh --headless --out DIR; ./run.sh --help).
set -euo pipefail
cd "$(dirname "$0")"

headless=
arguments=()
for argument in "$@"; do
  if [ "$argument" = --headless ]; then headless=yes; else arguments+=("$argument"); fi
done
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || headless=yes

if [ -n "$headless" ]; then
  cmake/setup.sh core
  cmake/build.sh cli terratact
  [[ " $* " == *" --out"* ]] || arguments+=(--out build/demo)
  exec build/cli/app/terratact demo "${arguments[@]}"
else
  cmake/setup.sh core gui
  cmake/build.sh release terratact-console
  exec build/release/app/terratact-console "${arguments[@]}"
fi
