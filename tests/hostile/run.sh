#!/bin/sh -e
# Makes files that attack their readers, and prints time and peak memory of every command for each file.
#   tests/hostile/run.sh [BUILD] [--large]   sessions (tests/cli/hostile_files.py); BUILD: default build/release
#   tests/hostile/run.sh --texts [BUILD]     text files: scenes, ground, logs, DBC, TOML (tests/cli/hostile_texts.py);
#                                            models, parts, compressed recordings (tests/cli/hostile_binaries.py)
cd "$(dirname "$0")/../.."
if [ "${1:-}" = --texts ]; then
  TERRATACT_CLI=${2:-build/release}/app/terratact TERRATACT_SOURCE_DIR=$PWD exec python3 -B tests/cli/reader_costs_test.py --table
fi
build=build/release
case ${1:---large} in --*) ;; *) build=$1; shift ;; esac
exec python3 -B tests/cli/hostile_files.py "$build/app/terratact" "$build/tests/make_session" "$@"
