#!/usr/bin/env bash
# Runs a program as root inside the user-mode Linux of tests/kernel/build.sh. It has the host's files and the caller's
# environment and directory:
#   tests/kernel/run.sh [--timeout SECONDS] [--clock host|guest] [--gpio LABEL:NAME,NAME...] PROGRAM [ARGUMENT...]
#   --timeout  host time until the kernel is killed; default 120
#   --clock    host (default): the host's clock. guest: the clock advances only when every process waits. No deadline is
#              missed on a busy host, and computing takes no time. A busy loop without clock calls never ends
#   --gpio     creates a gpio-sim chip with this label and lines of these names
# vcan0 exists and is up; its frames return to their sender after sending, like those of a controller.
# Output goes to standard output as it arrives. Exit status: the program's; 77 without a kernel, 124 after the timeout,
# 125 if the kernel ended without the program.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
linux=$(cd "$here/../.." && pwd)/.deps/kernel/linux
seconds=120
clock=host
gpio=
while [ $# -gt 1 ]; do
  case $1 in
    --timeout) seconds=$2; shift 2 ;;
    --clock) clock=$2; shift 2 ;;
    --gpio) gpio=$2; shift 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || { echo "run.sh: which program?" >&2; exit 125; }
case $clock in
  host) travel=() ;;
  guest) travel=(time-travel=inf-cpu) ;;
  *) echo "run.sh: --clock is host or guest, not $clock" >&2; exit 125 ;;
esac
[ -x "$linux" ] || { echo "SKIPPED: no kernel for the kernel tests (tests/kernel/build.sh makes it)"; exit 77; }

state=$(mktemp -d /tmp/terratact-kernel.XXXXXX)
trap 'rm -rf "$state"' EXIT
export -p >"$state/environment"
printf '%s\n' "$PWD" >"$state/directory"
printf '%s\n' "$gpio" >"$state/gpio"
printf '%q ' "$@" >"$state/command"
head -c 32 /dev/urandom >"$state/seed"

# The guest's memory is a file, in /dev/shm if that is large enough.
memory=$state
[ "$(df --output=avail -k /dev/shm 2>/dev/null | tail -n 1)" -lt 1048576 ] 2>/dev/null || memory=/dev/shm

status=0
TMPDIR=$memory timeout --kill-after=5 "$seconds" "$linux" mem=512M uml_dir="$state/" umid=guest \
  root=host rootfstype=hostfs rootflags=/ rw init="$here/init.sh" terratact_state="$state" vcan.echo=1 \
  "${travel[@]}" quiet loglevel=1 panic=-1 con=null con0=null,fd:1 ssl=null </dev/null || status=$?
if [ -s "$state/status" ]; then exit "$(cat "$state/status")"; fi
if [ "$status" = 124 ] || [ "$status" = 137 ]; then
  echo "run.sh: still running after $seconds s, ended: $*" >&2
  exit 124
fi
echo "run.sh: the kernel ended before the program did (its exit status was $status): $*" >&2
exit 125
