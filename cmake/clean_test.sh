#!/usr/bin/env bash
# Sets up, builds and tests the committed files in a clean root of each release, as a new user would. Needs root and a
# network:
#   cmake/clean_test.sh [bookworm] [trixie]      without names: both
# It runs ./run.sh --headless and ./test.sh. The logs are build/clean/RELEASE.log; table.txt has the steps with their
# seconds. If $CCACHE_DIR is set, compilers keep their results there.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$PWD/build/clean
log=/dev/null
. cmake/clean_root.sh
[ $# != 0 ] || set -- bookworm trixie
begin_table "$out"

for release; do
  echo "-- $release"
  log=$out/$release.log
  : >"$log"
  make_root
  mount --bind /dev "$root/dev"
  mount --bind /dev/pts "$root/dev/pts"
  mount -t sysfs sysfs "$root/sys"
  copy_sources
  step "./run.sh --headless" inside $sources/run.sh --headless
  step "./test.sh" inside $sources/test.sh
  tail -n 1 "$log"
  grep 'warning:' "$root$sources"/build/*.log && echo "the compiler warned" || true
  remove_root
done
steps_table | tee "$out/table.txt"
