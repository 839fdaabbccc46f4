#!/usr/bin/env bash
# Tests apt_repository.sh on a clean Debian of a release; needs root and a network:
#   cmake/apt_repository_check.sh PACKAGE.deb RELEASE
# apt installs the package from a signed repository. It upgrades it to a higher version that was added later. It refuses
# the repository after somebody changed it. The higher version is the same package with another number. The log is
# repository.log beside the package.
set -euo pipefail
[ $# = 2 ] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
set -- "$(realpath "$1")" "$2"
cd "$(dirname "$0")/.."
log=$(dirname "$1")/repository.log
. cmake/clean_root.sh
release=$2
: >"$log"
work=$(mktemp -d)
trap 'remove_root; rm -rf "$work"' EXIT
old=$(dpkg-deb -f "$1" Version)
new=${old/\~/+1~}

higher_version() {
  dpkg-deb -R "$1" "$work/files"
  sed -i "s/^Version: .*/Version: $new/" "$work/files/DEBIAN/control"
  dpkg-deb --root-owner-group -b "$work/files" "$work/higher.deb"
}

# The system sees the repository as a copy in /srv.
add() {
  cmake/apt_repository.sh "$work/keys" "$work/served" "$1"
  rm -rf "$root/srv/terratact"
  cp -r "$work/served" "$root/srv/terratact"
}

use_repository() {
  install -m 644 "$root/srv/terratact/terratact.gpg" "$root/usr/share/keyrings/terratact.gpg"
  echo "deb [signed-by=/usr/share/keyrings/terratact.gpg] file:///srv/terratact $release main" \
    >"$root/etc/apt/sources.list.d/terratact.list"
  inside apt-get -q update
}

# apt-get reports a bad signature as an error if it may not use the old lists.
update_strictly() { inside apt-get -q -o APT::Update::Error-Mode=any update; }

installed_is() { [ "$(inside dpkg-query -W -f '${Version}' terratact)" = "$1" ]; }

change_repository() {
  sed -i 's/^Codename: .*/&x/' "$root/srv/terratact/dists/$release/InRelease"
  ! update_strictly >"$work/refusal" 2>&1
  grep -E 'BADSIG|signature' "$work/refusal"
}

step "package of a higher version" higher_version "$1"
make_root
step "repository with $old" add "$1"
step "apt-get update" use_repository
step "apt-get install terratact" inside apt-get -q -y install --no-install-recommends terratact
step "$old is installed" installed_is "$old"
step "repository with $new" add "$work/higher.deb"
step "apt-get update again" update_strictly
step "apt-get upgrade" inside apt-get -q -y upgrade
step "$new is installed" installed_is "$new"
step "a changed repository is refused" change_repository
echo "passed: apt installs and upgrades $(basename "$1") on $release (log: $log)"
