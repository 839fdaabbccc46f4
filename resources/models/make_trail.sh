#!/bin/sh
# Makes default.ttn, the networks of the method trail that the program ships. They learn from 4000 simulated drives in
# one plane and 7000 on two tracks over varied ground, with exact heights. Three drives of ten are on soft ground. Every
# tenth drive gives the errors. It takes an hour on two cores.
# Usage: resources/models/make_trail.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(
    cd "$folder"
    PATH="$(dirname "$terratact"):$PATH"
    ground='--terrain varied --soft-drives 0.3 --exact-truth'
    terratact simulate --drives 4000 $ground --seed 101 --out drives.csv
    terratact simulate --drives 3500 $ground --tracks --seed 102 --out track_drives.csv
    terratact simulate --drives 3500 $ground --tracks --seed 103 --out more_track_drives.csv
    OPENBLAS_NUM_THREADS=1 terratact train --drives drives.csv --track-drives track_drives.csv --track-drives more_track_drives.csv \
        --networks 8 --seed 1 --out default.ttn
)
mv "$folder/default.ttn" default.ttn
