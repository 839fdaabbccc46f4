#!/bin/sh
# Writes docs/evaluation.md and its figures: every method on terrain outside the shipped model's training data. Takes
# about half an hour on two cores.
# Usage: docs/evaluate.sh path/to/terratact PROFILES.csv [INDEX.csv COLUMN]
#   PROFILES.csv   terrain to drive over, in the format of `terratact simulate --terrain`
#   INDEX.csv      its classes: COLUMN of the row whose `row` is the profile's number
# With TERRATACT_PAIRS=LINES.csv it also makes docs/two_tracks.md (docs/two_tracks.sh).
set -eu
terratact=$(realpath "$1")
profiles=$(realpath "$2")
classes=
if [ $# -ge 4 ]; then classes="--classes $(realpath "$3") --class-column $4"; fi
cd "$(dirname "$0")"
docs=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$profiles" profiles.csv
page=$folder/evaluation.md

say() { printf '%s\n' "$@" >>"$page"; }

# Runs terratact without output.
quiet() { "$terratact" "$@" >/dev/null 2>&1; }

# Runs terratact and prints the command with its output.
show() {
  say '' "    terratact $(printf '%s ' "$@" | sed "s#$(dirname "$profiles")/##g")" '' '```'
  "$terratact" "$@" 2>/dev/null | grep -v '^written to' >>"$page"
  say '```'
}

# Prints the line of one method in the table of scores, under another name.
scores() {
  "$terratact" evaluate --data "$2" --methods local --seed 1 --out scratch 2>/dev/null |
    awk -v name="$1" '/^Scores/ {on = 1} on && $1 == "local" {sub("^local *", ""); printf "%-16s%s\n", name, $0; exit}' >>"$page"
}

say '# Evaluation' '' \
  'The command above each number printed it. This command made the whole page,' '' \
  "    docs/evaluate.sh path/to/terratact $(basename "$profiles") [INDEX.csv COLUMN]" '' \
  'with the shipped model, which was trained on simulated drives over generated ground alone' \
  '(`resources/models/make_one_plane.sh`). Brackets are 95 % bootstrap intervals over whole drives.' \
  'median\* is the median over bins -0.3 to 0.5. The baselines are fitted on the same training scenes.' \
  'Milliseconds are wall-clock time on a machine that does other work, too. [tradeoff.md](tradeoff.md) measures the cost of the methods.' \
  '[two_tracks.md](two_tracks.md) judges estimates of left and right.'

say '' '## Real terrain' '' \
  'Drives over profiles cut from scans that had no part in training or in any choice of a constant.'
show simulate --terrain profiles.csv --count 300 --exact-truth --seed 1 --out real.csv
# shellcheck disable=SC2086
show evaluate --data real.csv --seed 1 $classes --out real
say '' '![Fig. 8](fig8.svg)' '' '![Fig. 9](fig9.svg)' '' '![PIT](pit.svg)'
cp real/fig8.svg real/fig9.svg real/pit.svg "$docs/"

say '' '## Generated ground of another seed'
show simulate --terrain varied --count 150 --exact-truth --seed 2 --out unseen.csv
show evaluate --data unseen.csv --methods pafc,clearance,joint,local --seed 1 --out unseen

say '' '## Missing sensors' '' \
  'The same scenes, real and generated, where currents or forces were not measured (core/README.md).' \
  'These scenes hold the mean of both arrays. The row *right array* keeps the left one alone, with the noise that the simulation gives each array.' \
  'These scans were used to choose how the processes without them are made. The real rows are therefore no independent test.'
show evaluate --missing --data real.csv --methods local --seed 1 --out lacking
show evaluate --missing --data unseen.csv --methods local --seed 1 --out lacking
say '' 'Three in ten training drives are on soft ground, into which the robot sinks. Without forces, no reading distinguishes soft from firm ground.' \
  'The bands then hold for the mix of both. They cover more of the truth on firm ground, and less on soft ground. The mix of the training:'
show simulate --terrain varied --count 1500 --exact-truth --soft-drives 0.3 --seed 3 --out mixed.csv
show evaluate --missing --data mixed.csv --methods local --seed 1 --out lacking
say '' 'Soft ground alone:'
show simulate --terrain varied --count 600 --exact-truth --soft-drives 1 --seed 3 --out soft.csv
show evaluate --missing --data soft.csv --methods local --seed 1 --out lacking

say '' '## The paper’s training set' '' \
  'The same real scenes, the model trained as in the paper: 28 runs over boxes of two heights.'
show simulate --terrain boxes --seed 1 --out boxes.csv
quiet train --data boxes.csv --seed 1 --out boxes.ttm
show evaluate --model boxes.ttm --data real.csv --methods pafc,local --seed 1 --out boxes

say '' '## Order of the scan' '' \
  'The conditionals are trained one by one and need not belong to one joint distribution.'
quiet simulate --terrain profiles.csv --count 60 --exact-truth --seed 2 --out few.csv
for order in forward reverse random; do
  say '' "    terratact evaluate --data few.csv --methods pafc,clearance --scan $order --seed 1 --out scan" '' '```'
  "$terratact" evaluate --data few.csv --methods pafc,clearance --scan "$order" --seed 1 --out scan 2>/dev/null |
    sed -n '/^Scores/,/^clearance/p' | grep -E 'Scores|method|pafc|clearance' >>"$page"
  say '```'
done

say '' '## Choosing the probe' '' \
  'A probe reads the truth with an sd of 30 mm. `sd`: the paper’s rule. `variance`, `step`: the largest expected' \
  'reduction of the total variance, or of the entropy of a step.' '' \
  '    terratact evaluate --data real.csv --methods joint,local --probes --seed 1 --out probes' '' '```'
"$terratact" evaluate --data real.csv --methods joint,local --probes --seed 1 --out probes 2>/dev/null |
  sed -n '/^Probes/,/^$/p' >>"$page"
say '```'

say '' '## Disturbances' '' \
  'Method `local`, the same model, the same profiles:' '' \
  '    terratact simulate --terrain profiles.csv --count 300 --exact-truth --seed 1 --disturb NAME --out disturbed.csv' \
  '    terratact evaluate --data disturbed.csv --methods local --seed 1 --out scratch' '' '```' \
  'disturbance              median*             median       mean |error|               CRPS    80 % covers  50 %  95 %  width ms/scene'
scores none real.csv
for name in imu-noise forces-high forces-low dead-element soft-ground light-robot heavy-robot friction-free; do
  quiet simulate --terrain profiles.csv --count 300 --exact-truth --seed 1 --disturb "$name" --out disturbed.csv
  scores "$name" disturbed.csv
done
say '```'
mv "$page" "$docs/evaluation.md"
if [ -n "${TERRATACT_PAIRS:-}" ]; then "$docs/two_tracks.sh" "$terratact" "$TERRATACT_PAIRS" "$docs/../build/release/tests"; fi
