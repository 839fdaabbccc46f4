#!/usr/bin/env bash
# Installs missing packages of the named groups; prints nothing if none is missing:
#   cmake/setup.sh [core] [gui] [test] [tidy] [package] [publish] [kernel]
#   core  compiler and libraries of the core, the drivers and the command line
#   gui   Qt 6, and Qwt for Qt 6: the system's, else built into .deps/qwt
#   test  libraries and tools of the tests      tidy  clang, clang-tidy, clang-format
#   package  tools to make a Debian package
#   publish  tools to test packages on clean systems and to make an apt repository: cmake/packages.sh
#   kernel  tools to build and run the kernel of tests/kernel/; libgpiod 2 in .deps/libgpiod2
# Packages are installed by apt (with sudo if needed); the system's apt sources are not changed.
set -euo pipefail
cd "$(dirname "$0")/.."

qwt_version=6.3.0
qwt_sha256=dcb085896c28aaec5518cbc08c0ee2b4e60ada7ac929d82639f6189851a6129a
qwt_suites="forky sid"
qwt_prefix=$PWD/.deps/qwt
gpiod_version=2.2.1
gpiod_sha256=0e948049c309b87c220fb24ee0d605d7cd5b72f22376e608470903fffa2d4b18
gpiod_suites="trixie forky sid"
gpiod_prefix=$PWD/.deps/libgpiod2
log=$PWD/.deps/setup.log

declare -A packages=(
  [core]="g++ cmake ninja-build pkg-config libeigen3-dev libopenblas-dev liblapacke-dev libhwy-dev libnlopt-dev
          libboost-math-dev libsqlite3-dev libsodium-dev zlib1g-dev libtomlplusplus-dev libcli11-dev libfmt-dev
          libcairo2-dev libgpiod-dev fonts-dejavu-core"
  [gui]="qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools qt6-wayland qmake6 libgl-dev libasound2-dev make bzip2 fonts-dejavu-core"
  [test]="libgtest-dev librapidcheck-dev libbenchmark-dev python3 python3-numpy python3-scipy
          python3-can can-utils sqlite3 parallel xvfb xauth xdotool
          appstream desktop-file-utils man-db groff-base dpkg-dev file"
  [tidy]="clang clang-tidy clang-format lld git"
  [package]="dpkg-dev file gzip"
  [publish]="debootstrap debian-archive-keyring lintian reprepro gnupg"
  [kernel]="linux-source gcc make flex bison bc libelf-dev xz-utils iproute2 can-utils gpiod libgpiod-dev"
)

fail() {
  echo "set-up: $*" >&2
  exit 1
}

# Prints the given packages that are not installed.
missing() {
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
      sed -n 's/^installed //p' | sort -u)
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
  local wanted
  wanted=$(missing "$@" | xargs)
  [ -n "$wanted" ] || return 0
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
    fail "packages are missing and sudo is not there; as root run: apt-get install $wanted"
  echo "set-up: installing $wanted"
  local apt=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y -o DPkg::Lock::Timeout=300)
  as_root "${apt[@]}" update >>"$log" 2>&1 || echo "apt-get update failed" >>"$log"
  # shellcheck disable=SC2086
  as_root "${apt[@]}" install --no-install-recommends $wanted >>"$log" 2>&1 ||
    fail "apt-get install failed: $(grep '^E:' "$log" | tail -n 1) (all of it in ${log#"$PWD"/})"
}

# Prints the mirror that this machine uses for its release.
debian_mirror() {
  local release
  # shellcheck disable=SC1091
  release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  # shellcheck disable=SC2016
  apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' |
    awk -v release="$release" '$1 == release || $1 ~ /^(old)*stable$/ { print $2; exit }'
}

# fetch_source PACKAGE VERSION SHA256 SUITES DIR: puts the source tarball into DIR. It comes from the first of the
# suites that has this version, through a private set of apt lists.
fetch_source() {
  local package=$1 version=$2 sha256=$3 suites=$4 dir=$5 mirror suite
  mirror=$(debian_mirror)
  [ -n "$mirror" ] || fail "found no Debian mirror in the apt sources for the source of $package"
  mkdir -p "$dir"/lists/partial "$dir"/cache/archives/partial
  local apt=(env LC_ALL=C apt-get -q -o Dir::State::Lists="$dir/lists" -o Dir::Cache="$dir/cache"
    -o Dir::Etc::SourceList="$dir/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o Acquire::Languages=none -o Acquire::Check-Valid-Until=false -o Debug::NoLocking=1)
  [ "$(id -u)" != 0 ] || apt+=(-o APT::Sandbox::User=root)
  for suite in $suites; do
    echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" >"$dir/sources.list"
    if "${apt[@]}" update && (cd "$dir" && "${apt[@]}" source --download-only --tar-only "$package") &&
      echo "$sha256 $(echo "$dir/$package"_*.orig.tar.*)" | sha256sum --check; then
      return 0
    fi >>"$log" 2>&1
    rm -f "$dir/$package"_*
  done
  fail "could not fetch the source of $package $version from the Debian mirror (see ${log#"$PWD"/})"
}

# build_source NAME PACKAGE VERSION SHA256 SUITES PREFIX COMMAND: fetches and unpacks a source, and COMMAND builds and
# installs it into PREFIX. PREFIX is then marked complete.
build_source() {
  local name=$1 package=$2 version=$3 sha256=$4 suites=$5 prefix=$6 build=$7
  local dir=$prefix-build
  echo "set-up: building $name $version, a minute or two"
  rm -rf "$dir" "$prefix"
  mkdir -p "$dir/source"
  fetch_source "$package" "$version" "$sha256" "$suites" "$dir"
  (tar -xf "$dir/$package"_*.orig.tar.* -C "$dir/source" --strip-components=1 && cd "$dir/source" && "$build") \
    >>"$log" 2>&1 || fail "$name $version did not build (see ${log#"$PWD"/})"
  touch "$prefix/complete"
  rm -rf "$dir"
}

build_qwt() {
  sed -i -E -e "s|^( *QWT_INSTALL_PREFIX *= ).*|\1$qwt_prefix|" \
    -e 's/^( *QWT_CONFIG *\+= *Qwt(Dll|Polar|Widgets|Designer|Examples|Playground|Tests|OpenGL))/#\1/' \
    qwtconfig.pri &&
    qmake6 && make -j"$(nproc)" && make install
}

# Only a library, linked into the tests.
build_gpiod() {
  ./configure --prefix="$gpiod_prefix" --enable-tools=no --disable-shared --with-pic &&
    make -j"$(nproc)" && make install
}

# Some releases have these parts in a package of their own, or name the package after the version of the compiler.
install_by_release() {
  if [[ " $* " == *" gui "* ]] && ! compgen -G '/usr/lib/*/qt6/plugins/iconengines/libqsvgicon.so' >/dev/null; then
    install_packages qt6-svg-plugins  # the icons; on Debian 12 a part of libqt6svg6
  fi
  if [[ " $* " == *" tidy "* ]]; then
    install_packages "libclang-rt-$(clang++ -dumpversion | cut -d . -f 1)-dev"  # libraries of the sanitizers
  fi
}

[ -w . ] || fail "cannot write to $PWD"
mkdir -p .deps
exec 9>.deps/lock
flock 9
wanted=()
for group in "$@"; do
  [ -n "${packages[$group]:-}" ] || fail "unknown group '$group' (core, gui, test, tidy, package, publish, kernel)"
  # shellcheck disable=SC2206
  wanted+=(${packages[$group]})
done
: >"$log"
install_packages "${wanted[@]}"
install_by_release "$@"
if [[ " $* " == *" gui "* ]] && [ ! -e "$qwt_prefix/complete" ] && [ -n "$(missing libqwt-qt6-dev)" ]; then
  if [ -n "$(apt-cache madison libqwt-qt6-dev 2>/dev/null)" ]; then
    install_packages libqwt-qt6-dev
  else
    build_source Qwt qwt $qwt_version $qwt_sha256 "$qwt_suites" "$qwt_prefix" build_qwt
  fi
fi
if [[ " $* " == *" kernel "* ]] && [ ! -e "$gpiod_prefix/complete" ]; then
  build_source libgpiod libgpiod $gpiod_version $gpiod_sha256 "$gpiod_suites" "$gpiod_prefix" build_gpiod
fi
