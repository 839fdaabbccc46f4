#!/usr/bin/env bash
# Fuzzes the parsers of untrusted input with libFuzzer:
#   tests/fuzz/run.sh SECONDS [TARGET...]     e.g. 60, or 28800 scene_file for a night
# Runs the programs of `cmake/build.sh fuzz`, by default all, SECONDS each and two at a time. They start from the seeds
# in the repository and from earlier findings (build/fuzz/corpora). A program fails if it crashes, violates a promise,
# needs over 2 s for one input or over 256 MiB. The script names the input; the program reproduces the failure with that
# file as argument. TERRATACT_FUZZ_JOBS: number of parallel programs. TERRATACT_FUZZ_TIMEOUT: replaces the 2 s of
# wall-clock time on a busy machine. TERRATACT_FUZZ_BUILD: replaces build/fuzz; build/dev has the same programs, but there
# libFuzzer does not see comparisons, so it finds rare inputs later.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${TERRATACT_FUZZ_BUILD:-build/fuzz}
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [TARGET...]}
shift
targets=("$@")
[ $# != 0 ] || targets=($(find "$build/fuzz" -maxdepth 1 -type f -executable -printf '%f\n' | sort))

scratch=$(mktemp -d -p "$([ -w /dev/shm ] && echo /dev/shm || echo "${TMPDIR:-/tmp}")")
trap 'kill $(jobs -p) 2>/dev/null || true; wait; rm -rf "$scratch"' EXIT
export TMPDIR=$scratch OPENBLAS_NUM_THREADS=1 UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS=quarantine_size_mb=16:malloc_context_size=8:strict_string_checks=1  # faster, and within 256 MiB
mkdir -p "$build/findings"

# run_target NAME: runs a program with its output in $build/findings/NAME.log.
run_target() {
  local name=$1 own=$build/corpora/$1 options=() seeds=()
  mkdir -p "$own"
  [ ! -e "tests/fuzz/$name.dict" ] || options+=("-dict=tests/fuzz/$name.dict")
  # shellcheck disable=SC2207
  [ ! -e "tests/fuzz/$name.options" ] || options+=($(cat "tests/fuzz/$name.options"))
  [ ! -d "tests/fuzz/corpora/$name" ] || seeds+=("tests/fuzz/corpora/$name")
  "$build/fuzz/$name" "$own" "${seeds[@]}" -rss_limit_mb=256 -timeout="${TERRATACT_FUZZ_TIMEOUT:-2}" -max_total_time="$seconds" \
    -print_final_stats=1 -artifact_prefix="$build/findings/$name-" "${options[@]}" >"$build/findings/$name.log" 2>&1
}

# report NAME STATUS: prints one line of numbers; for a failure, its kind and the input.
report() {
  local name=$1 log=$build/findings/$1.log executions rate covered corpus
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  read -r covered corpus < <(sed -nE 's|.* cov: ([0-9]+) .* corp: ([0-9]+)/.*|\1 \2|p' "$log" | tail -n 1)
  printf '%-14s %10s executions  %6s /s  %5s inputs  %5s edges  %s\n' "$name" "${executions:-?}" "${rate:-?}" \
    "${corpus:-?}" "${covered:-?}" "$([ "$2" = 0 ] && echo 'no finding' || echo FAILED)"
  [ "$2" != 0 ] || return 0
  grep -m 3 -E 'broken promise|ERROR:|runtime error|^terminate|  what' "$log" || true
  sed -n "s|.*Test unit written to |input: |p" "$log"
  echo "log: $log"
}

failed=0
declare -A running=()
finish_one() {
  local process status=0
  wait -n -p process || status=$?
  report "${running[$process]}" "$status"
  [ "$status" = 0 ] || failed=1
  unset "running[$process]"
}
for target in "${targets[@]}"; do
  [ -x "$build/fuzz/$target" ] || { echo "no fuzz program $target: cmake/build.sh fuzz builds them" >&2; exit 1; }
  [ "${#running[@]}" -lt "${TERRATACT_FUZZ_JOBS:-2}" ] || finish_one
  run_target "$target" &
  running[$!]=$target
done
while [ "${#running[@]}" != 0 ]; do finish_one; done
exit $failed
