#!/bin/sh
# Writes docs/tradeoff.md, its figure, and the presets' costs that the console shows
# (resources/models/default.presets.csv).
# Usage: docs/tradeoff.sh path/to/terratact
set -eu
terratact=$(realpath "$1")
docs=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
page=tradeoff.md

say() { printf '%s\n' "$@" >>"$page"; }
show() {
  say '' "    terratact $*" '' '```'
  "$terratact" "$@" 2>/dev/null >>"$page"
  say '```'
}

say '# Time and accuracy' '' \
  '`docs/tradeoff.sh build/release/app/terratact` made this page from generated scenes, so anybody can repeat it.' \
  "Processor: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), one core.  Times are medians of processor time over the scenes; compare ratios.  They exclude the factors that a model computes on first use." '' \
  'The distance from a long run of the same method shows the cost of an economy. Economies are fewer draws, single precision or fewer inducing rows.' \
  'The error against the truth shows whether it matters.  A method may be certain and wrong: compare both.' \
  'The presets `fast`, `balanced` and `accurate` (`--quality`, and the console’s menu) are points of the table.  They are measured as the program runs them: they end once the chains have converged.' \
  '`pafac` makes two estimates: one to choose where the arm probes, and one with its reading. The time is of the second.'
show simulate --terrain varied --count 8 --exact-truth --seed 2 --out scenes.csv
show tradeoff --data scenes.csv --seed 1 --out tradeoff
say '' '![Time and accuracy](tradeoff.svg)'
cp tradeoff/tradeoff.svg "$docs/"
cp tradeoff/presets.csv "$docs/../resources/models/default.presets.csv"
mv "$page" "$docs/tradeoff.md"
