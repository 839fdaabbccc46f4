#!/bin/bash
# Process 1 inside the kernel of run.sh; run.sh passes its task in $terratact_state.
stty -opost -echo 2>/dev/null   # the console is a pipe to a file, not a terminal
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t configfs configfs /sys/kernel/config
mount -t devtmpfs devtmpfs /dev
ln -sf /proc/self/fd /dev/fd
mkdir -p /dev/pts /dev/shm
mount -t devpts devpts /dev/pts
mount -t tmpfs tmpfs /dev/shm
mount -t tmpfs tmpfs /run

# The guest has no entropy source, and getrandom() would block; it gets the host's, in RNDADDENTROPY's format.
perl -e 'open(my $pool, ">", "/dev/random"); ioctl($pool, 0x40085203, pack("iia32", 256, 32, join("", <>)))' \
  "$terratact_state/seed"

ip link set lo up
ip link add dev vcan0 type vcan && ip link set vcan0 up

# Creates a gpio-sim chip from LABEL:NAME,NAME...
make_chip() {
  local label=${1%%:*} bank=/sys/kernel/config/gpio-sim/panel/bank0 names i
  IFS=, read -ra names <<<"${1#*:}"
  mkdir -p "$bank"
  echo "${#names[@]}" >"$bank/num_lines"
  echo "$label" >"$bank/label"
  for i in "${!names[@]}"; do
    mkdir "$bank/line$i" && echo "${names[i]}" >"$bank/line$i/name"
  done
  echo 1 >/sys/kernel/config/gpio-sim/panel/live
}
gpio=$(cat "$terratact_state/gpio")
[ -z "$gpio" ] || make_chip "$gpio"

(
  # shellcheck disable=SC1091
  . "$terratact_state/environment"
  export TERM=dumb
  cd "$(cat "$terratact_state/directory")" || exit 125
  eval "exec $(cat "$terratact_state/command")"
)
echo $? >"$terratact_state/status"
sync
echo o >/proc/sysrq-trigger   # power off
sleep infinity
