#!/bin/sh
# Puts the pictures of a folder (tests/app/screens_test.cpp) on one sheet, DIR/contact_sheet.png; wants imagemagick.
#   tests/app/contact_sheet.sh DIR
set -eu
cd "$1"
rm -f contact_sheet.png
montage -label '%t' -font DejaVu-Sans -pointsize 22 -tile 4x -geometry 960x+16+16 -background '#8899aa' ./*.png contact_sheet.png
echo "$1/contact_sheet.png"
