#!/bin/sh
# Makes one_plane.ttm from 20 000 simulated scenes over varied ground, three drives of ten on soft ground, with exact
# heights. The paper's conditionals see the first 1400 of them with a scanner's noise. make_default.sh adds two tracks.
# Usage: resources/models/make_one_plane.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    terratact simulate --terrain varied --count 20000 --soft-drives 0.3 --exact-truth --seed 1 --out varied.csv
    terratact train --data varied.csv --scanner-sd 0.012 --seed 1 --out one_plane.ttm
)
mv "$folder/one_plane.ttm" one_plane.ttm
