#!/usr/bin/env bash
# Builds the Debian package and tests it on a clean Debian 12; needs root and a network:
#   cmake/package_check.sh [PACKAGE.deb]      tests this package instead of building one
# It runs lintian and creates a minimal system with debootstrap (from $MIRROR, if set). There apt installs the package
# without recommended packages, and a user runs both programs. Then the package is purged, and nothing of it may remain.
# The log is build/package/check.log; the console's picture is beside it.
set -euo pipefail
[ $# = 0 ] || set -- "$(realpath "$1")"
cd "$(dirname "$0")/.."
[ "$(id -u)" = 0 ] || { echo "package_check.sh: needs root, for debootstrap and chroot" >&2; exit 1; }
cmake/setup.sh core gui package
out=$PWD/build/package
log=$out/check.log
mkdir -p "$out"
: >"$log"

root=$(mktemp -d /var/tmp/terratact-root.XXXXXX)
chmod 755 "$root"
clean_up() {
  ! mountpoint -q "$root/proc" || umount "$root/proc"
  rm -rf --one-file-system "$root"
}
trap clean_up EXIT

# step WORDS COMMAND...: prints the step and runs it; on failure it prints the end of the log and exits.
step() {
  local words=$1
  shift
  echo "== $words" | tee -a "$log"
  "$@" >>"$log" 2>&1 || { tail -n 20 "$log" >&2; echo "FAILED: $words (all of it in $log)" >&2; exit 1; }
}

inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} "$@"
}

# A user with only a home folder and the offscreen display.
as_user() {
  inside setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/home/operator QT_QPA_PLATFORM=offscreen \
    sh -c 'cd && exec "$@"' sh "$@"
}

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
  cmake/build.sh package terratact terratact-console
  rm -f "$out"/terratact_*.deb
  step "cpack" cpack --config "$out/CPackConfig.cmake" -G DEB -B "$out"
  set -- "$out"/terratact_*.deb
fi
step "lintian" lintian --allow-root --fail-on error,warning "$1"
# shellcheck disable=SC2086
step "minimal Debian 12" debootstrap --variant=minbase bookworm "$root" ${MIRROR:-}
mount -t proc proc "$root/proc"
install -d -o 1000 -g 1000 "$root/home/operator"
cp "$1" "$root/tmp/terratact.deb"
step "apt-get install" inside apt-get -q -y install --no-install-recommends /tmp/terratact.deb
rm "$root/tmp/terratact.deb"
step "every library is there" libraries_found
step "terratact --version" as_user terratact --version
step "terratact demo" as_user terratact demo --out demo
step "terratact-console --version" as_user terratact-console --version
step "terratact-console --screenshot" as_user terratact-console --screenshot console.png
cp "$root"/home/operator/console.png "$out/check.png"
cp "$root"/home/operator/demo/second.png "$out/check_demo.png"
step "apt-get purge" inside apt-get -q -y purge terratact
step "nothing is left" nothing_left
echo "passed: $(basename "$1") installs, runs and goes (log: ${log#"$PWD"/})"
