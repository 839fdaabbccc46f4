# shellcheck shell=bash
# Functions for scripts that work in a minimal Debian of a release. It is deleted at the end unless its folder is named.
# debootstrap makes it, from $MIRROR and with the options $DEBOOTSTRAP, if set. A script that sources this file needs
# root, and sets `log` first. Missing tools are installed. If $STEPS names a file, each step adds a line to it: release,
# step, seconds.

[ "$(id -u)" = 0 ] || { echo "$(basename "$0"): needs root, for debootstrap and chroot" >&2; exit 1; }
cmake/setup.sh publish
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
root=
keep=
emulator=  # runs the programs of another architecture
sources=/usr/src/terratact  # in the root
commit=  # of all roots that the script makes

# step WORDS COMMAND...: prints the step and runs it; on failure it prints the end of the log and exits. The command runs
# in another process, because bash ignores `set -e` in a function on the left of ||.
step() {
  local words=$1 start=$SECONDS
  shift
  echo "== $words" | tee -a "$log"
  "$@" >>"$log" 2>&1 &
  wait $! || { tail -n 20 "$log" >&2; echo "FAILED: $words (all of it in $log)" >&2; exit 1; }
  [ -z "${STEPS:-}" ] || printf '%s\t%s\t%s\n' "$release" "$words" $((SECONDS - start)) >>"$STEPS"
}

remove_root() {
  [ -n "$root" ] || return 0
  local folder
  for folder in proc dev/pts dev sys root/.cache/ccache; do
    ! mountpoint -q "$root/$folder" || umount "$root/$folder" ||
      { echo "still in use, and left: $root/$folder" >&2; return 1; }
  done
  [ -n "$keep" ] || rm -rf --one-file-system "$root"
  root=
}
trap remove_root EXIT

# make_root [FOLDER]: makes the minimal Debian of $release in $root, with a user. With FOLDER it is made there, and used
# again the next time. A release that debootstrap does not know is one of Ubuntu, whose mirror must be named.
make_root() {
  local script=
  if [ ! -e "/usr/share/debootstrap/scripts/$release" ]; then
    [ -n "${MIRROR:-}" ] || { echo "$release is no release of Debian; for one of Ubuntu set MIRROR" >&2; exit 1; }
    script=gutsy
  fi
  keep=${1:-}
  root=${keep:-$(mktemp -d /var/tmp/terratact-root.XXXXXX)}
  mkdir -p "$root"
  chmod 755 "$root"
  if [ ! -e "$root/etc/debian_version" ] || [ -e "$root/debootstrap" ]; then
    # shellcheck disable=SC2086
    step "minimal $release" debootstrap --variant=minbase ${DEBOOTSTRAP:-} "$release" "$root" ${MIRROR:-} $script
  fi
  mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
  install -d -o 1000 -g 1000 "$root/home/operator"
}

# copy_sources: copies the committed files to $sources of the root; of an earlier copy only .deps stays. If $CCACHE_DIR is
# set, compilers in the root keep their results there.
copy_sources() {
  mkdir -p "$root$sources"
  find "$root$sources" -mindepth 1 -maxdepth 1 ! -name .deps -exec rm -rf {} +
  commit=${commit:-$(git rev-parse HEAD)}
  git archive "$commit" | tar -x -C "$root$sources"
  step "apt-get update" inside apt-get -q update
  [ -n "${CCACHE_DIR:-}" ] || return 0
  mkdir -p "$CCACHE_DIR" "$root/root/.cache/ccache"
  mountpoint -q "$root/root/.cache/ccache" || mount --bind "$CCACHE_DIR" "$root/root/.cache/ccache"
  step "ccache" inside apt-get -q -y install --no-install-recommends ccache
}

# Runs a command in the root.
inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${CCACHE_DIR:+CMAKE_CXX_COMPILER_LAUNCHER=ccache} \
    ${CMAKE_BUILD_PARALLEL_LEVEL:+CMAKE_BUILD_PARALLEL_LEVEL="$CMAKE_BUILD_PARALLEL_LEVEL"} "$@"
}

# Runs a command in the root as a user with only a home folder and the offscreen display.
as_user() {
  inside setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/home/operator QT_QPA_PLATFORM=offscreen \
    sh -c 'cd && exec "$@"' sh ${emulator:+"$emulator"} "$@"
}

# try_programs FOLDER: a user runs both programs of the folder; an empty name means those that the shell finds.
# Pictures of the exploration and of the console are left in $out.
try_programs() {
  step "terratact --version" as_user "$1"terratact --version
  step "terratact demo" as_user "$1"terratact demo --out demo
  step "terratact-console --version" as_user "$1"terratact-console --version
  step "terratact-console --screenshot" as_user "$1"terratact-console --screenshot console.png
  cp "$root"/home/operator/console.png "$out/check.png"
  cp "$root"/home/operator/demo/second.png "$out/check_demo.png"
}

# begin_table FOLDER: makes the folder, and a file $STEPS in it.
begin_table() {
  mkdir -p "$1"
  export STEPS=$1/steps.tsv
  : >"$STEPS"
}

# steps_table: prints the steps of $STEPS as a table.
steps_table() { awk -F '\t' '{ printf "%-10s %-40s %6d s\n", $1, $2, $3 }' "$STEPS"; }
