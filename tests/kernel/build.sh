#!/usr/bin/env bash
# Builds the user-mode Linux of the kernel tests into .deps/kernel/linux, unless it exists. Takes three minutes, from
# Debian's kernel source. Installs nothing. If it cannot be built, it prints one line and exits with 77 (cmake/setup.sh
# kernel installs what is missing).
set -euo pipefail
cd "$(dirname "$0")/../.."
source=$(printf '%s\n' /usr/src/linux-source-*.tar.xz | sort -V | tail -n 1)  # the newest: 6.1 of Debian 12, 6.12 of 13
config=$PWD/tests/kernel/uml.config
kernel=$PWD/.deps/kernel
log=$kernel/build.log

cannot() {
  echo "no kernel for the kernel tests: $*" >&2
  exit 77
}

# A built kernel is valid for one configuration of one source.
key=$(cat "$config" tests/kernel/build.sh <(stat -L -c '%s %Y' "$source" 2>/dev/null || true) | sha256sum | cut -d ' ' -f 1)

# Every line of the fragment must be in the kernel's final configuration.
check_config() {
  local line wrong=0
  while read -r line; do
    grep -qx "$line" .config || { echo "error: the kernel's configuration lacks $line"; wrong=1; }
  done < <(grep '^CONFIG_' "$config")
  return $wrong
}

# This kernel reserves 2696 bytes of vector registers per process. Hosts with more registers (AMX) refuse that size, so
# the host's size is used.
fit_registers() {
  sed -i 's/HOST_FP_SIZE, 2696/HOST_FP_SIZE, 16384/' arch/x86/um/user-offsets.c &&
    sed -i -E -e 's/^(static )?int have_xstate_support;/&\nstatic unsigned long xstate_size = FP_SIZE * sizeof(unsigned long);/' \
      -e 's/iov_len = FP_SIZE \* sizeof\(unsigned long\)/iov_len = xstate_size/' \
      -e 's/^\t\thave_xstate_support = 1;/\t\thave_xstate_support = 1, xstate_size = iov.iov_len;/' \
      arch/x86/um/os-Linux/registers.c &&
    grep -q 16384 arch/x86/um/user-offsets.c &&
    [ "$(grep -c xstate_size arch/x86/um/os-Linux/registers.c)" = 5 ]
}

# The edges of simulated lines need interrupt numbers, which this kernel otherwise has only for simulated PCI devices.
add_interrupts() {
  local header=arch/um/include/asm/irq.h
  sed -i -E 's/^(#define NR_IRQS\s+)UM_LAST_SIGNAL_IRQ$/\1(UM_LAST_SIGNAL_IRQ + 64)/' $header &&
    [ "$(grep -c 'UM_LAST_SIGNAL_IRQ + 64' $header)" = 2 ]
}

build() {
  rm -rf "$kernel/source" &&
    mkdir -p "$kernel/source" &&
    tar -xf "$source" -C "$kernel/source" --strip-components=1 &&
    cd "$kernel/source" &&
    fit_registers &&
    add_interrupts &&
    make ARCH=um tinyconfig &&
    scripts/kconfig/merge_config.sh -m .config "$config" &&
    make ARCH=um olddefconfig &&
    check_config &&
    make ARCH=um -j"$(nproc)" linux &&
    strip -o "$kernel/linux.new" linux &&
    mv "$kernel/linux.new" "$kernel/linux" &&
    cd "$kernel/../.." &&
    rm -rf "$kernel/source"
}

[ "$(uname -m)" = x86_64 ] || cannot "it is built for x86_64 only, this is $(uname -m)"
mkdir -p "$kernel"
exec 9>"$kernel/lock"
flock 9
if [ -x "$kernel/linux" ] && [ "$(cat "$kernel/key" 2>/dev/null)" = "$key" ]; then exit 0; fi
[ -e "$source" ] || cannot "the kernel source $source is missing; cmake/setup.sh kernel installs it"
for tool in make gcc flex bison bc xz strip ip; do
  command -v "$tool" >/dev/null || cannot "$tool is missing; cmake/setup.sh kernel installs it"
done
echo "building a user-mode Linux for the kernel tests, three minutes"
rm -f "$kernel/key"
(build) >"$log" 2>&1 ||
  cannot "it did not build: $(grep -m 1 -w error "$log" || tail -n 1 "$log") (all of it in ${log#"$PWD"/})"
if ! tests/kernel/run.sh test -e /sys/class/net/vcan0 >>"$log" 2>&1 9>&-; then
  rm "$kernel/linux"
  cannot "it does not run here (see ${log#"$PWD"/})"
fi
echo "$key" >"$kernel/key"
