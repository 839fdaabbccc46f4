#!/bin/sh -e
# Makes session files that attack whoever opens them (tests/cli/hostile_files.py) and prints the time and the peak memory
# of every command for each.
#   tests/hostile/run.sh [BUILD] [--large]   BUILD: folder of the built programs, else build/release
cd "$(dirname "$0")/../.."
build=build/release
case ${1:---large} in --*) ;; *) build=$1; shift ;; esac
exec python3 -B tests/cli/hostile_files.py "$build/app/terratact" "$build/tests/make_session" "$@"
