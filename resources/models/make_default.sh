#!/bin/sh
# Makes default.ttm, the model the program ships: 1400 simulated scenes over varied ground, then the
# 22 Gaussian processes.  Usage: resources/models/make_default.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    terratact simulate --terrain varied --seed 1 --out varied.csv
    terratact train --data varied.csv --seed 1 --out default.ttm
)
mv "$folder/default.ttm" default.ttm
