#!/usr/bin/env bash
# Builds the Debian package of each release in a clean root of that release. Tests it and an apt repository of it in
# other roots. Needs root and a network:
#   cmake/packages.sh [bookworm] [trixie]      without names: both
# Packages are built from the committed files. For each release build/packages/RELEASE has the package, a log of the
# build, and what package_check.sh and apt_repository_check.sh leave. build/packages has table.txt, the steps with their
# seconds, and SHA256SUMS. Names in the packages: $HOMEPAGE and $MAINTAINER ("Name <address>"), if set. If $CCACHE_DIR is
# set, compilers keep their results there.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$PWD/build/packages
log=/dev/null
. cmake/clean_root.sh
[ $# != 0 ] || set -- bookworm trixie
version=$(cmake/version.sh)
begin_table "$out"

# In the root: makes the package from $sources.
build_inside() {
  local options=(-D TERRATACT_PACKAGE_VERSION="$version" ${HOMEPAGE:+-D TERRATACT_HOMEPAGE="$HOMEPAGE"}
    ${MAINTAINER:+-D CPACK_PACKAGE_CONTACT="$MAINTAINER"})
  inside sh -c 'cd $0 && cmake --preset package "$@" && cmake --build --preset package --parallel "$(nproc)"' $sources "${options[@]}"
}

make_package() {
  log=$out/$release/build.log
  rm -rf "${out:?}/$release"
  mkdir -p "$out/$release"
  make_root
  copy_sources
  step "setup.sh core gui package" inside $sources/cmake/setup.sh core gui package
  step "build" build_inside
  step "cpack" inside sh -c "cd $sources/build/package && cpack -G DEB"
  cp "$root$sources"/build/package/terratact_*.deb "$out/$release/"
  remove_root
}

for release; do
  echo "-- $release"
  make_package
  cmake/package_check.sh "$out/$release"/terratact_*.deb "$release"
  cmake/apt_repository_check.sh "$out/$release"/terratact_*.deb "$release"
done
(cd "$out" && sha256sum -- */terratact_*.deb >SHA256SUMS)
{ steps_table && cat "$out/SHA256SUMS"; } | tee "$out/table.txt"
