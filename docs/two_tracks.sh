#!/bin/sh
# Writes docs/two_tracks.md: estimates of left and right by the shipped model, on generated ground of another seed and on
# real ground. Minutes on two cores.
# Usage: docs/two_tracks.sh path/to/terratact PAIRS.csv TESTS
#   PAIRS.csv   ground lines (docs/files.md) with a column `kind`: "mild" for a mild cross slope
#   TESTS       folder of the test programs, build/release/tests: they print the checks of the rest pose
set -eu
terratact=$(realpath "$1")
pairs=$(realpath "$2")
rest=$(realpath "$3")/core.sim
cd "$(dirname "$0")"
docs=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$pairs" pairs.csv
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i == "kind") kind = i} NR == 1 || $kind == "mild"' pairs.csv >mild.csv
page=$folder/two_tracks.md

say() { printf '%s\n' "$@" >>"$page"; }

# errors WORDS FOLDER CLASS MEDIAN MEAN: one row of the targets, errors of `two tracks` [mm].
errors() {
  awk -F, -v words="$1" -v class="$3" -v median="$4" -v mean="$5" '$1 == "two tracks" && $2 == class {
    found = sprintf("%.1f / %.1f", 1000 * $4, 1000 * $5)
    split(found, reached, " / ")
    printf "| %s: median / mean error [mm] | %s / %s | %s | %s |\n", words, median, mean, found,
      (reached[1] <= median + 0 && reached[2] <= mean + 0) ? "yes" : "no"
  }' "$2/tracks.csv" >>"$page"
}

# loss WORDS FOLDER: one row of the targets, errors of `two tracks` less those of `one plane` [mm].
loss() {
  awk -F, -v words="$1" '$2 == "all" {median[$1] = 1000 * $4; mean[$1] = 1000 * $5} END {
    found = sprintf("%+.1f / %+.1f", median["two tracks"] - median["one plane"], mean["two tracks"] - mean["one plane"])
    split(found, lost, " / ")
    printf "| %s: median / mean error less that of `one plane` [mm] | 0.5 / 0.5 | %s | %s |\n", words, found,
      (lost[1] + 0 <= 0.5 && lost[2] + 0 <= 0.5) ? "yes" : "no"
  }' "$2/tracks.csv" >>"$page"
}

# Prints the scenes of a file whose true heights are equal left and right in every bin.
equalSides() {
  awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) at[$i] = i; print; next}
    {for (name in at) if (name ~ /^left_h_/ && $at[name] != $at["right" substr(name, 5)]) next; print}' "$1"
}

# bands WORDS FOLDER CLASS: one row of the targets, share of true heights in the 80 % bands.
bands() {
  awk -F, -v words="$1" -v class="$3" '$1 == "two tracks" && $2 == class {
    printf "| %s: 80 %% bands cover [%%] | 76 … 86 | %.1f | %s |\n", words, 100 * $6, ($6 >= 0.76 && $6 <= 0.86) ? "yes" : "no"
  }' "$2/tracks.csv" >>"$page"
}

# steps WORDS FOLDER BRIER: two rows of the targets, probability of a step.
steps() {
  awk -F, -v words="$1" -v brier="$3" '$1 == "two tracks" {
    off = $7 - $8 < 0 ? $8 - $7 : $7 - $8
    printf "| %s: Brier score of a step per side | %s | %.3f | %s |\n", words, brier, $3, ($3 <= brier + 0) ? "yes" : "no"
    printf "| %s: mean P of either side less its share | 0.030 | %.3f | %s |\n", words, off, (off <= 0.03) ? "yes" : "no"
  }' "$2/track_steps.csv" >>"$page"
}

# Runs terratact and prints the command with its output.
show() {
  say '' "    terratact $*" '' '```'
  "$terratact" "$@" 2>/dev/null >>"$page"
  say '```'
}

say '# Two tracks' '' \
  'The command above each number printed it. This command made the whole page,' '' \
  "    docs/two_tracks.sh path/to/terratact $(basename "$pairs") build/release/tests" '' \
  'with the shipped model. Its two tracks learnt from simulated drives over generated ground alone' \
  '(`resources/models/make_default.sh`). Errors are those of each side. Bins from -0.3 to +0.2 m are those of the track'"'"'s line.' \
  'Bins from +0.3 m on are those of the flippers'"'"' line. The last section compares them with the targets. The approaches are' '' \
  '- `two tracks`: both sides together; a scene that is symmetric within its noise is estimated as one plane;' \
  '- `always two`: both sides together in every scene;' \
  '- `one plane`: the model of one plane on the means of both sides, for both sides;' \
  '- `one per side`: the model of one plane on each side'"'"'s readings, plus or minus y sin(roll).' '' \
  'The classes: `within` has |roll| and flipper differences of 0.10 rad at most, `beyond` has more. `symmetric` is symmetric' \
  'within the noise of the sensors.'

say '' '## Generated ground of another seed'
show simulate --tracks --terrain varied --count 1500 --soft-drives 0.3 --exact-truth --seed 2 --out generated.csv
show evaluate --tracks --data generated.csv --methods local --seed 1 --out generated

say '' '## Real ground, any heading' '' 'Pairs of lines cut from height maps that had no part in training or in any choice of a constant.'
show simulate --tracks --terrain pairs.csv --count 3000 --exact-truth --seed 1 --out real.csv
show evaluate --tracks --data real.csv --methods local --seed 1 --out real

say '' '## Real ground, mild cross slope'
show simulate --tracks --terrain mild.csv --count 1000 --exact-truth --seed 1 --out mild_scenes.csv
show evaluate --tracks --data mild_scenes.csv --methods local --seed 1 --out mild

say '' '## Equal lines' '' \
  'The ground is equal left and right, and the noise of the sensors is not. Of this generated ground, scenes count whose' \
  'true heights are equal on both sides in every bin.'
show simulate --tracks --terrain varied --count 5000 --soft-drives 0.3 --exact-truth --seed 3 --out varied.csv
equalSides varied.csv >equal.csv
show evaluate --tracks --data equal.csv --methods local --seed 1 --out equal
say '' 'On real ground, the first line of each pair lies under both sides.'
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i == "pair") pair = i} $pair != last {print} {last = $pair}' \
  pairs.csv >lines.csv
show simulate --tracks --terrain lines.csv --count 500 --exact-truth --seed 1 --out equal_real.csv
show evaluate --tracks --data equal_real.csv --methods local --seed 1 --out equal_real

say '' '## Method joint'
show evaluate --tracks --data mild_scenes.csv --methods joint --seed 1 --out joint

say '' '## Methods that have learnt one plane' '' \
  'The first 200 of the scenes over a mild cross slope. `clearance` estimates each side for itself where both sides differ. The' \
  'paper'"'"'s four gain little or nothing by it, and stay with one plane as the paper has them.'
head -n 201 mild_scenes.csv >mild_few.csv
show evaluate --tracks --data mild_few.csv --methods pa,pac,pafc,clearance --quality balanced --seed 1 --out sampled

say '' '## Missing sensors' '' 'The first 300 of the generated scenes.'
head -n 301 generated.csv >few.csv
show evaluate --tracks --missing --data few.csv --methods local --seed 1 --out missing

say '' '## Hazards on one side and on both'
show hazards --tracks --drives 4

say '' '## The simulated rest pose' '' 'On equal lines, poses are those of the simulation of one plane, to 1e-9 rad and 0.01 N.' '' \
  "    $(basename "$rest")" '' '```'
"$rest" --gtest_filter='TwoTrackRest.on*' | grep -E '^(equal lines|mirrored ground)' >>"$page"
say '```'

say '' '## Targets' '' \
  'At most, or between, for `two tracks` by the method *local*. The bands of generated and of real ground have the same target.' '' \
  '| ground, class: number | target | reached | met |' '|---|---|---|---|'
errors 'generated, all' generated all 13 27
errors 'generated, within' generated within 11 24
errors 'generated, beyond' generated beyond 14.5 28.5
errors 'real, all' real all 10 24
errors 'real, within' real within 6.5 11.5
errors 'real, beyond' real beyond 15.5 32
errors 'real, mild cross slope' mild all 9.5 24
errors 'real, bin +0.6 m' real "'+0.6 m" 13 28
errors 'real, bin +0.7 m' real "'+0.7 m" 21 41
loss 'generated, equal lines' equal
loss 'real, equal lines' equal_real
for ground in generated real mild; do
  for class in all within beyond; do bands "$ground, $class" $ground $class; done
done
steps generated generated 0.150
steps real real 0.102
steps 'real, mild cross slope' mild 0.102

mv "$page" "$docs/two_tracks.md"
