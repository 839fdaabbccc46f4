#!/usr/bin/env bash
# Tests a Debian package on a clean Debian; needs root and a network:
#   cmake/package_check.sh                         builds the package here, and tests it on this machine's release
#   cmake/package_check.sh PACKAGE.deb [RELEASE]   tests this package on that release, such as trixie
# It runs lintian and creates a minimal system. There apt installs the package without recommended packages, and a user
# runs both programs. Then the package is purged, and nothing of it may remain. The log is check.log beside the package,
# with pictures of the console and of the exploration.
set -euo pipefail
[ $# = 0 ] || set -- "$(realpath "$1")" "${@:2}"
cd "$(dirname "$0")/.."
out=$PWD/build/package
[ $# = 0 ] || out=$(dirname "$1")
log=$out/check.log
. cmake/clean_root.sh
release=${2:-$release}
[ $# != 0 ] || cmake/setup.sh core gui package
mkdir -p "$out"
: >"$log"

libraries_found() {
  inside ldd /usr/bin/terratact /usr/bin/terratact-console | tee "$root/tmp/ldd"
  ! grep 'not found' "$root/tmp/ldd"
}

# dpkg's backups of earlier states and its logs do not count.
nothing_left() {
  ! find "$root" -mindepth 1 -xdev -iname '*terratact*' -not -path "$root/home/*" -print | grep . &&
    ! grep -rIil terratact "$root/etc" "$root/usr" "$root/var/lib" --exclude='status-old'
}

if [ $# = 0 ]; then
  cmake --preset package >"$log"  # the version may be another one since the last time
  cmake/build.sh package terratact terratact-console
  rm -f "$out"/terratact_*.deb
  step "cpack" cpack --config "$out/CPackConfig.cmake" -G DEB -B "$out"
  set -- "$out"/terratact_*.deb
fi
step "lintian" lintian --allow-root --fail-on error,warning "$1"
make_root
cp "$1" "$root/tmp/terratact.deb"
step "apt-get install" inside apt-get -q -y install --no-install-recommends /tmp/terratact.deb
rm "$root/tmp/terratact.deb"
step "every library is there" libraries_found
try_programs ""
step "apt-get purge" inside apt-get -q -y purge terratact
step "nothing is left" nothing_left
echo "passed: $(basename "$1") installs, runs and goes on $release (log: $log)"
