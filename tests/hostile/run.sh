#!/bin/sh -e
# Makes session files that attack their readers (tests/cli/hostile_files.py). Prints time and peak memory of every
# command for each file.
#   tests/hostile/run.sh [BUILD] [--large]   BUILD: folder of the built programs, default build/release
cd "$(dirname "$0")/../.."
build=build/release
case ${1:---large} in --*) ;; *) build=$1; shift ;; esac
exec python3 -B tests/cli/hostile_files.py "$build/app/terratact" "$build/tests/make_session" "$@"
