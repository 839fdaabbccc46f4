#!/bin/sh
# Makes default.ttm, the model the program ships, from 20 000 simulated scenes over varied ground, three drives
# of ten on soft ground, with exact heights; the paper's conditionals see the first 1400 of them with a scanner's noise.  Usage: resources/models/make_default.sh path/to/terratact
# Once it is committed, make_card.sh makes its card.
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    terratact simulate --terrain varied --count 20000 --soft-drives 0.3 --exact-truth --seed 1 --out varied.csv
    terratact train --data varied.csv --scanner-sd 0.012 --seed 1 --out default.ttm
)
mv "$folder/default.ttm" default.ttm
