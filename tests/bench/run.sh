#!/usr/bin/env bash
# Benchmarks the sampler against NumPy, alternating on one thread, and prints a table of goals and results.
#   tests/bench/run.sh [build directory] [rounds]       default: build/headless 3
# The build directory holds an optimised build (presets headless, release).
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/headless}
rounds=${2:-3}
export OPENBLAS_NUM_THREADS=1

cmake --build "$build" --target terratact-bench >/dev/null
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
for ((round = 1; round <= rounds; ++round)); do
  "$build"/tests/terratact-bench --benchmark_filter='-scenes/|cancelWaits|restPose' --benchmark_format=json --benchmark_min_time=0.3 \
    >"$results/ours-$round.json" 2>/dev/null
  /usr/bin/python3 -B tests/bench/peer_numpy.py >"$results/numpy-$round.json" 2>"$results/ways"
  if grep -qw avx512f /proc/cpuinfo; then # limits NumPy to AVX2
    OPENBLAS_CORETYPE=Haswell NPY_DISABLE_CPU_FEATURES='AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL' \
      /usr/bin/python3 -B tests/bench/peer_numpy.py >"$results/avx2-$round.json" 2>"$results/ways"
  fi
done
# These results differ by little, so they alternate five times each.
"$build"/tests/terratact-bench --benchmark_filter=scenes/ --benchmark_format=json --benchmark_min_time=0.05 \
  --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
  >"$results/scenes.json" 2>/dev/null
/usr/bin/python3 -B tests/bench/table.py "$results"
