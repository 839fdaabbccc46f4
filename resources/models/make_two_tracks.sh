#!/bin/sh
# Makes two_tracks.ttm, the shipped model of left and right: default.ttm, every bit of what it knows of one plane, and two
# tracks that learn from 20 000 simulated scenes over ground that differs left and right, three drives of ten on soft
# ground, with exact heights.  It keeps 12 000 of them.  Usage: resources/models/make_two_tracks.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp default.ttm "$folder/"
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    terratact simulate --tracks --terrain varied --count 20000 --soft-drives 0.3 --exact-truth --seed 1 --out tracks.csv
    terratact train --plane default.ttm --tracks tracks.csv --seed 1 --out two_tracks.ttm
)
mv "$folder/two_tracks.ttm" two_tracks.ttm
