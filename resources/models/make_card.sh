#!/bin/sh
# Makes default.card.toml. It states when and on what ground the shipped model was trained. It has the errors of its
# methods on generated ground of another seed. Needs the repository's history. It takes minutes on two cores.
# Usage: resources/models/make_card.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
rm -f default.card.toml
trained=$(TZ=UTC0 git log -1 --date=format-local:%Y-%m-%dT%H:%M:%SZ --format=%cd -- default.ttm)
made=$(sed -n 's/^ *terratact simulate \(.*\) --out .*/\1/p' make_one_plane.sh)
"$terratact" model card default.ttm --trained "$trained" --terrain "terratact simulate $made"
"$terratact" simulate --terrain varied --count 300 --soft-drives 0.3 --exact-truth --seed 2 --out "$folder/varied_seed_2.csv"
"$terratact" evaluate --card --model default.ttm --data "$folder/varied_seed_2.csv" \
    --methods pafc,clearance,joint,local --seed 1 --out "$folder/evaluation"
