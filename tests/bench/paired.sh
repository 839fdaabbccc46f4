#!/usr/bin/env bash
# Compares the benchmarks of two builds. The builds take turns, so that both meet the same load. Prints the least CPU
# time of each benchmark. Exits with 1 if a benchmark takes more than 1.05 times as long in the new build.
#   tests/bench/paired.sh [--limit RATIO] OLD_BUILD NEW_BUILD [ROUNDS]       default: 1.05, and 6 rounds, the fewest
# The build directories hold optimised builds of the same preset (headless, release).
set -euo pipefail
limit=1.05
if [[ ${1:-} == --limit && $# -ge 2 ]]; then
  limit=$2
  shift 2
fi
rounds=${3:-6}
if (($# < 2 || $# > 3)) || ! [[ $rounds =~ ^[0-9]+$ ]] || ((rounds < 6)); then
  echo "usage: $0 [--limit RATIO] OLD_BUILD NEW_BUILD [ROUNDS]; at least 6 rounds" >&2
  exit 2
fi
old=$(realpath "$1")
new=$(realpath "$2")
cd "$(dirname "$0")/../.."
export OPENBLAS_NUM_THREADS=1

cmake --build "$old" --target terratact-bench >/dev/null
cmake --build "$new" --target terratact-bench >/dev/null
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
# Left out: waits and fresh pages, which are measured once, and the processor's peak, which no build changes.
measure() {
  "$1"/tests/terratact-bench --benchmark_filter='-cancelWaits|touchesOfFreshPages|peak/' --benchmark_format=json \
    --benchmark_min_time=0.1 >"$results/$2.json" 2>/dev/null
}
for ((round = 1; round <= rounds; ++round)); do
  if ((round % 2)); then
    measure "$old" "old-$round"
    measure "$new" "new-$round"
  else
    measure "$new" "new-$round"
    measure "$old" "old-$round"
  fi
done
/usr/bin/python3 -B tests/bench/paired_table.py --limit "$limit" "$results"
