#!/bin/sh
# Arranges the pictures of a folder (tests/app/console/screens/screens_test.cpp) on readable sheets of nine, in their order:
# DIR/sheet-01.png, … Needs imagemagick. NAMES: shell pattern of the pictures (default: all).
#   tests/app/contact_sheet.sh DIR [NAMES]
set -eu
cd "$1"
rm -f sheet-*.png
# shellcheck disable=SC2086 # the names are a pattern
set -- ${2:-*.png}
sheet=1
# Makes one sheet at a time, because imagemagick cannot load all pictures at once.
while [ $# -gt 0 ]; do
  nine=
  while [ $# -gt 0 ] && [ "$(printf '%s' "$nine" | wc -w)" -lt 9 ]; do
    nine="$nine $1"
    shift
  done
  # shellcheck disable=SC2086 # a list of names
  montage -label '%t' -font DejaVu-Sans -pointsize 20 -tile 3x3 -geometry '900x>+10+10' -background '#8899aa' \
    $nine "$(printf 'sheet-%02d.png' "$sheet")"
  sheet=$((sheet + 1))
done
ls "$PWD"/sheet-*.png
