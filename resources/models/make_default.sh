#!/bin/sh
# Makes default.ttm, the model the program ships: one_plane.ttm, every bit of what it knows of one plane, and two tracks.
# These learn from 26 000 simulated scenes with exact heights over ground that differs left and right. Three drives of
# ten are on soft ground. 12 000 of the scenes are kept. Once it is committed, make_card.sh makes its card.
# Usage: resources/models/make_default.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp one_plane.ttm "$folder/"
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    terratact simulate --tracks --terrain varied --count 26000 --soft-drives 0.3 --exact-truth --seed 1 --out tracks.csv
    terratact train --plane one_plane.ttm --tracks tracks.csv --seed 1 --out default.ttm
)
mv "$folder/default.ttm" default.ttm
