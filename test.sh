#!/usr/bin/env bash
# Sets up, builds and runs every test: core, command line, and GUI offscreen. Arguments go to ctest: ./test.sh -R gibbs.
# The last line counts the passed tests.
set -euo pipefail
cd "$(dirname "$0")"
cmake/setup.sh core gui test
cmake/build.sh release
results=build/release/tests.xml
rm -f "$results"
status=0
ctest --preset release "$@" || status=$?
[ -e "$results" ] || { echo "ctest left no results" >&2; exit 1; }
cmake/count_tests.sh "$results"
exit $status
