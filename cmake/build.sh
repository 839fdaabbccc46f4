#!/usr/bin/env bash
# Configures a preset if it is new or CMakePresets.json changed, and builds it:
#   cmake/build.sh PRESET             builds the whole preset, tests included
#   cmake/build.sh PRESET TARGET...   builds these targets; a new configuration leaves the tests out
# On a terminal the build shows its progress. Otherwise it prints only failures.
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

# CMake's own re-runs do not read presets. --fresh: if a preset names another compiler, CMake keeps nothing else of it in
# an old cache. A build made for a few targets lacks the tests. They are added to it, and what is built is kept.
configure() {
  echo "building preset $preset (the first time takes minutes)"
  cmake --preset "$preset" "$@" >"$log" 2>&1 || fail "configuring"
}
without_tests='^TERRATACT_TESTS:.*=OFF'
if [ ! "$dir/build.ninja" -nt CMakePresets.json ]; then
  # shellcheck disable=SC2046
  configure --fresh $([ $# = 0 ] || echo -D TERRATACT_TESTS=OFF)
elif [ $# = 0 ] && grep -q "$without_tests" "$dir/CMakeCache.txt"; then
  sed -i "/$without_tests/s/OFF$/ON/" "$dir/CMakeCache.txt"  # unless the preset has none
  configure
fi
build=(--preset "$preset")
[ $# = 0 ] || build=("$dir" --target "$@")
build+=(--parallel "$(nproc)")  # Ninja's own choice of two more takes a tenth more time: compilers need the caches
if [ -t 1 ]; then
  cmake --build "${build[@]}" 2>&1 | tee "$log" | grep --line-buffered -v '^ninja: no work' || true
  [ "${PIPESTATUS[0]}" = 0 ] || fail "building"
else
  cmake --build "${build[@]}" >"$log" 2>&1 || fail "building"
fi
