#!/usr/bin/env bash
# Benchmarks training: the paper's 22 processes, its cost by number of rows, and sparse processes of many rows.
#   tests/bench/training.sh [build directory] [most rows]       default: build/headless 11200
# The build directory holds an optimised build (presets headless, release). Takes about twenty-five minutes and 4 GB of
# memory.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "${1:-build/headless}")
most=${2:-11200}
table=$PWD/tests/bench/training_table.py
export OPENBLAS_NUM_THREADS=1

cmake --build "$build" --target terratact terratact-bench-likelihood >/dev/null
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

scenes() { "$build/app/terratact" simulate --terrain varied --exact-truth "$@" >/dev/null 2>&1; }
show() {
  echo "> $*"
  taskset -c 0,1 "$build/tests/terratact-bench-likelihood" "$@"
  echo
}
scenes --count 1400 --seed 5 --out scenes.csv
scenes --count $((most + most / 9)) --seed 6 --out many.csv # a few stops give no scene
scenes --count 5000 --seed 7 --out test.csv # with fewer scenes the random choice matters
sizes=()
for ((rows = most; rows >= most / 32 && rows > 1; rows /= 2)); do sizes=("$rows" "${sizes[@]}"); done
{
  show train scenes.csv 1400
  show growth "${sizes[@]}"
  show sparse many.csv "$most" test.csv 6 0 300 600 1200
  show sparse-bins many.csv "$most" test.csv 300 600 1200
} | /usr/bin/python3 -B "$table"
