#!/usr/bin/env bash
# Configures a preset if it is new or CMakePresets.json changed, and builds it:
#   cmake/build.sh PRESET             builds the whole preset, tests included
#   cmake/build.sh PRESET TARGET...   builds these targets; a new configuration leaves the tests out
# On a terminal the build shows its progress; otherwise it prints only failures.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=$1
shift
dir=build/$preset
log=$dir.log
mkdir -p build

fail() {
  grep -E -A8 'error:|CMake Error|FAILED:|^ld:' "$log" | head -n 60 >&2 || true
  echo "$1 of preset $preset failed: see above, all of it is in $log" >&2
  exit 1
}

# CMake's own re-runs do not read presets, and a build made for a few targets lacks the tests. --fresh: if a preset names
# another compiler, CMake keeps nothing else of it in an old cache.
without_tests=()
[ $# = 0 ] || without_tests=(-D TERRATACT_TESTS=OFF)
if [ ! "$dir/build.ninja" -nt CMakePresets.json ] ||
  { [ $# = 0 ] && grep -q '^TERRATACT_TESTS:.*=OFF' "$dir/CMakeCache.txt"; }; then
  echo "building preset $preset (the first time takes minutes)"
  cmake --preset "$preset" --fresh "${without_tests[@]}" >"$log" 2>&1 || fail "configuring"
fi
build=(--preset "$preset")
[ $# = 0 ] || build=("$dir" --target "$@")
if [ -t 1 ]; then
  cmake --build "${build[@]}" 2>&1 | tee "$log" | grep --line-buffered -v '^ninja: no work' || true
  [ "${PIPESTATUS[0]}" = 0 ] || fail "building"
else
  cmake --build "${build[@]}" >"$log" 2>&1 || fail "building"
fi
