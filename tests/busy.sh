#!/usr/bin/env bash
# Runs all tests of preset release beside busy programs, several times. It stops at the first run that fails, and prints a
# line for each run.
#   tests/busy.sh [RUNS [PROGRAMS]]      default: 3 runs beside 4 programs
set -eu
cd "$(dirname "$0")/.."
runs=${1:-3}
programs=${2:-4}
busy=()
trap 'kill "${busy[@]}" 2>/dev/null || true' EXIT
trap 'exit 130' INT TERM HUP
for _ in $(seq "$programs"); do
  while :; do :; done &
  busy+=($!)
done
for run in $(seq "$runs"); do
  begin=$SECONDS
  log=build/busy-$run.log
  ctest --preset release >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    echo "run $run beside $programs busy programs FAILED ($log)" >&2
    exit 1
  }
  echo "run $run beside $programs busy programs, $((SECONDS - begin)) s: $(grep 'tests passed' "$log")"
done
