#!/usr/bin/env bash
# Runs clang-tidy on every joined source of a build directory and every source compiled alone. It runs one process per
# processor, largest sources first, so that no long one is left for the end.
#   cmake/tidy.sh BUILD_DIRECTORY CLANG_TIDY
set -euo pipefail
build=$1 tidy=$2

# Prints the size in bytes of a source, including the sources it joins.
size() { { cat "$1" && sed -n 's/^#include "\(.*\)"/\1/p' "$1" | grep '^/' | xargs -r cat; } | wc -c; }

sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$build/compile_commands.json" | grep -E '/Unity/|/core/learn/.*_kernels_' |
  while read -r source; do echo "$(size "$source") $source"; done | sort -rn | cut -d ' ' -f 2- |
  xargs -P "$(nproc)" -n 1 "$tidy" -quiet -p "$build"
