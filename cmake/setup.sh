#!/usr/bin/env bash
# Installs missing packages of the named groups; prints nothing if none is missing:
#   cmake/setup.sh [--arch ARCHITECTURE] [core] [gui] [unit] [test] [tidy] [package] [publish] [kernel] [cluster] [scans]
#   core  compiler and libraries of the core, the drivers and the command line
#   gui   Qt 6, SDL 2 for gamepads, and Qwt for Qt 6: the system's, else built into .deps/qwt
#   unit  libraries of the tests of the core    test  libraries and tools of all tests
#   tidy  clang, clang-tidy, clang-format
#   package  tools to make a Debian package
#   publish  tools to test packages on clean systems and to make an apt repository: cmake/packages.sh
#   kernel  tools to build and run the kernel of tests/kernel/; libgpiod 2 in .deps/libgpiod2
#   cluster  Slurm, for the test of docs/clusters.md on a Slurm of one node
#   scans  public laser scans that Debian packages ship, for a test of terratact truth
# Packages are installed by apt (with sudo if needed); the system's apt sources are not changed.
# --arch arm64: the compiler and the libraries are those for arm64, for a cross build (cmake/arm64.sh). The other tools
# are this machine's. It is for the groups core, gui, unit and package.
set -euo pipefail
cd "$(dirname "$0")/.."

arch=          # empty: this machine's
multiarch='*'  # the folder of its libraries in /usr/lib
qwt_prefix=$PWD/.deps/qwt
gpiod_prefix=$PWD/.deps/libgpiod2
log=$PWD/.deps/setup.log
qmake=qmake6
os_release=/etc/os-release
keyrings=/usr/share/keyrings

declare -A packages=(
  [core]="g++ cmake ninja-build pkg-config libeigen3-dev libopenblas-dev liblapacke-dev libhwy-dev libnlopt-dev
          libboost-math-dev libsqlite3-dev libsodium-dev zlib1g-dev libbz2-dev liblz4-dev libzstd-dev libtomlplusplus-dev libcli11-dev libfmt-dev
          libcairo2-dev libgpiod-dev fonts-dejavu-core"
  [gui]="qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools qt6-wayland qmake6 libgl-dev libasound2-dev libsdl2-dev make bzip2 fonts-dejavu-core"
  [unit]="libgtest-dev librapidcheck-dev libbenchmark-dev python3"
  [test]="libgtest-dev librapidcheck-dev libbenchmark-dev python3 python3-numpy python3-scipy gnupg
          python3-can python3-rosbag python3-sensor-msgs python3-nav-msgs pcl-tools can-utils sqlite3 parallel xvfb xauth xdotool
          appstream desktop-file-utils man-db groff-base dpkg-dev file"
  [tidy]="clang clang-tidy clang-format lld git"
  [package]="dpkg-dev file gzip"
  [publish]="debootstrap debian-archive-keyring lintian reprepro gnupg"
  [kernel]="linux-source gcc make flex bison bc libelf-dev xz-utils iproute2 can-utils gpiod libgpiod-dev"
  [cluster]="slurm-wlm munge"
  [scans]="libcgal-demo"
)

fail() {
  echo "set-up: $*" >&2
  exit 1
}

# Prints the given packages that are not installed. An architecture is only in the names of other architectures' packages.
missing() {
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}:${Architecture}\n' "$@" 2>/dev/null |
      sed -n "s/^installed //p" | sed -E "s/:(all|$(dpkg --print-architecture))$//" | sort -u)
}

# Prints the names of the given packages for a cross build to $arch. The libraries are those of $arch, unless a package
# is for every architecture. Qt's moc, rcc and lrelease come with this machine's packages.
for_arch() {
  local name
  for name; do
    case $name in
    g++) printf '%s\n' "crossbuild-essential-$arch" qemu-user-static ;;
    qt6-base-dev | qt6-tools-dev) printf '%s\n' "$name" "$name:$arch" ;;
    lib*-dev | qt6-*-dev | zlib1g-dev | qmake6)
      if apt-cache show --no-all-versions "$name" 2>/dev/null | grep '^Architecture: all' >/dev/null; then
        echo "$name"
      else
        echo "$name:$arch"
      fi ;;
    *) echo "$name" ;;
    esac
  done
}

# set_arch ARCHITECTURE: sets what differs in a cross build.
set_arch() {
  arch=$1
  [ -n "$arch" ] || fail "--arch needs an architecture, such as arm64"
  dpkg --print-foreign-architectures | grep -qxF -- "$arch" ||
    fail "apt does not know the architecture '$arch'; as root run: dpkg --add-architecture $arch && apt-get update"
  install_packages dpkg-dev
  multiarch=$(dpkg-architecture -a "$arch" -q DEB_HOST_MULTIARCH 2>>"$log")
  qwt_prefix=$PWD/.deps/qwt-$multiarch
  qmake=$multiarch-qmake6
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

# Sets what differs between Debian and Ubuntu (docs/packages.md): mirror (as this machine uses it), keyring, components,
# and the suites that may hold a newer source. Ubuntu's mirrors of other architectures hold no sources.
describe_archive() {
  local id release key_package
  # shellcheck disable=SC1090,SC1091
  read -r id release < <(. "$os_release" && echo "${ID:-} ${ID_LIKE:-} ${UBUNTU_CODENAME:-${VERSION_CODENAME:-none}}" |
    awk '{ print (/ubuntu/ ? "ubuntu" : "debian"), $NF }')
  # shellcheck disable=SC2016
  mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' |
    awk -v release="$release" '$1 == release || $1 ~ /^((old)*stable|testing|unstable|sid)$/ { print $2; exit }')
  if [ "$id" = ubuntu ]; then
    mirror=$(sed 's|//ports\.|//archive.|; s|/ubuntu-ports|/ubuntu|' <<<"$mirror")
    keyring=$keyrings/ubuntu-archive-keyring.gpg
    key_package=ubuntu-keyring  # Debian names its package of these keys ubuntu-archive-keyring
    components="main universe"
    suites="$release devel"
  else
    keyring=$keyrings/debian-archive-keyring.gpg
    key_package=debian-archive-keyring
    components=main
    suites="$release trixie forky sid"
  fi
  [ -n "$mirror" ] || fail "found no mirror of $id $release in the apt sources"
  [ -e "$keyring" ] || fail "the key of the archive is missing: install $key_package"
}

# fetch_source PACKAGE LEAST DIR: puts a source tarball of the major version of LEAST into DIR. It comes from the first
# suite that has LEAST or newer, through a private set of apt lists. apt trusts only an index that the archive's key
# signed, and checks the tarball by that index. The machine's configuration cannot relax this. An index may be old,
# because a mirror may stand still. The tarball is checked even so. If no suite has it, DIR is removed.
fetch_source() {
  local package=$1 least=$2 dir=$3 suite version mirror keyring components suites
  describe_archive
  mkdir -p "$dir"/lists/partial "$dir"/cache/archives/partial
  local apt=(env LC_ALL=C apt-get -q -o Dir::State::Lists="$dir/lists" -o Dir::Cache="$dir/cache"
    -o Dir::Etc::SourceList="$dir/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o Acquire::AllowInsecureRepositories=false -o Acquire::AllowWeakRepositories=false
    -o APT::Get::AllowUnauthenticated=false
    -o Acquire::Languages=none -o Acquire::Check-Valid-Until=false -o Debug::NoLocking=1)
  [ "$(id -u)" != 0 ] || apt+=(-o APT::Sandbox::User=root)
  for suite in $suites; do
    echo "deb-src [signed-by=$keyring] $mirror $suite $components" >"$dir/sources.list"
    echo "$package from $suite" >>"$log"
    if "${apt[@]}" update >>"$log" 2>&1 &&
      (cd "$dir" && "${apt[@]}" source --download-only --tar-only "$package") >>"$log" 2>&1; then
      version=$(echo "$dir/$package"_*.orig.tar.*)
      version=${version#"$dir/$package"_} version=${version%%.orig.tar.*}
      [ "${version%%.*}" != "${least%%.*}" ] || dpkg --compare-versions "$version" lt "$least" || return 0
    fi
    rm -f "$dir/$package"_*
  done
  rm -rf "$dir"
  fail "no suite of the mirror ($suites) gave a signed source of $package ${least%%.*}, $least or newer (see ${log#"$PWD"/})"
}

# build_source NAME PACKAGE LEAST PREFIX COMMAND: fetches and unpacks a source, and COMMAND builds and installs it into
# PREFIX. PREFIX is then marked complete. COMMAND may leave its reason to fail in the file ../reason.
build_source() {
  local name=$1 package=$2 least=$3 prefix=$4 build=$5
  local dir=$prefix-build
  echo "set-up: building $name, a minute or two"
  rm -rf "$dir" "$prefix"
  mkdir -p "$dir/source"
  fetch_source "$package" "$least" "$dir"
  (tar -xf "$dir/$package"_*.orig.tar.* -C "$dir/source" --strip-components=1 && cd "$dir/source" && "$build") \
    >>"$log" 2>&1 || fail "$name did not build: $(cat "$dir/reason" 2>/dev/null || echo "see ${log#"$PWD"/}")"
  touch "$prefix/complete"
  rm -rf "$dir"
}

# Without this check a newer qwtconfig.pri would install into the system.
build_qwt() {
  sed -i -E -e "s|^( *QWT_INSTALL_PREFIX *= ).*|\1$qwt_prefix|" \
    -e 's/^( *QWT_CONFIG *\+= *Qwt(Dll|Polar|Widgets|Designer|Examples|Playground|Tests|OpenGL))/#\1/' \
    qwtconfig.pri
  if ! grep -qF "= $qwt_prefix" qwtconfig.pri || ! grep -qE '^ *QWT_CONFIG *\+= *QwtPlot' qwtconfig.pri ||
    grep -qE '^ *QWT_CONFIG *\+= *Qwt(Dll|Designer|Examples)' qwtconfig.pri; then
    echo "its qwtconfig.pri is not that of Qwt 6.3, so build_qwt in cmake/setup.sh must be adapted" >../reason
    return 1
  fi
  # Of another architecture, Debian 12's qmake does not find moc. The precompiled header saves a quarter of the time.
  echo '#include <QtWidgets>' >precompiled.h
  "$qmake" "QT_TOOL.moc.binary=$(qmake6 -query QT_HOST_LIBEXECS)/moc" \
    CONFIG+=precompile_header "PRECOMPILED_HEADER=$PWD/precompiled.h" && make -j"$(nproc)" && make install
}

# Only a library, linked into the tests.
build_gpiod() {
  ./configure --prefix="$gpiod_prefix" --enable-tools=no --disable-shared --with-pic &&
    make -j"$(nproc)" && make install
}

# Some releases have these parts in another package, or name the package after the version of the compiler.
install_by_release() {
  if [[ " $* " == *" gui "* ]] && ! compgen -G "/usr/lib/$multiarch/qt6/plugins/iconengines/libqsvgicon.so" >/dev/null; then
    install_packages "qt6-svg-plugins${arch:+:$arch}"  # the icons; on Debian 12 a part of libqt6svg6
  fi
  if [[ " $* " == *" tidy "* ]]; then
    install_packages "libclang-rt-$(clang++ -dumpversion | cut -d . -f 1)-dev"  # libraries of the sanitizers
    # From version 21 on, clang-tidy passes over system headers: a third of the time.
    local quick
    quick=$(apt-cache pkgnames clang-tidy-2 | grep -E '^clang-tidy-2[1-9]$' | sort -V | head -n 1) || true
    [ -z "$quick" ] || install_packages "$quick"
  fi
}

[ -w . ] || fail "cannot write to $PWD"
mkdir -p .deps
[ -w .deps ] && { [ ! -e .deps/lock ] || [ -w .deps/lock ]; } ||
  fail "cannot write to .deps, made by another user: sudo chown -R $(id -un) .deps build"
exec 9>.deps/lock
flock 9
: >"$log"
if [ "${1:-}" = --arch ]; then
  set_arch "${2:-}"
  shift 2
fi
wanted=()
for group in "$@"; do
  [ -n "${packages[$group]:-}" ] || fail "unknown group '$group' (core, gui, unit, test, tidy, package, publish, kernel, cluster, scans)"
  # shellcheck disable=SC2206
  wanted+=(${packages[$group]})
done
[ -z "$arch" ] || mapfile -t wanted < <(for_arch "${wanted[@]}")
install_packages "${wanted[@]}"
install_by_release "$@"
qwt=libqwt-qt6-dev${arch:+:$arch}
if [[ " $* " == *" gui "* ]] && [ ! -e "$qwt_prefix/complete" ] && [ -n "$(missing "$qwt")" ]; then
  if [ -n "$(apt-cache madison "$qwt" 2>/dev/null)" ]; then
    install_packages "$qwt"
  else
    build_source Qwt qwt 6.2 "$qwt_prefix" build_qwt
  fi
fi
if [[ " $* " == *" kernel "* ]] && [ ! -e "$gpiod_prefix/complete" ]; then
  build_source libgpiod libgpiod 2.0 "$gpiod_prefix" build_gpiod
fi
