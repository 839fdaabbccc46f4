#!/usr/bin/env bash
# Brings the translations up to the sources: new texts arrive unfinished, those no longer used leave.
#   resources/translations/update.sh [DIR]   writes into DIR instead of here
# Then fill them in (Qt Linguist, or an editor) and run the test app/translations_test.
set -euo pipefail
[ $# = 0 ] || set -- "$(realpath "$1")"
cd "$(dirname "$0")/../.."
here=$PWD/resources/translations
to=${1:-$here}
# Of a Qt 6: `lupdate` alone may be that of another Qt, or a program that starts it.
lupdate=$(command -v /usr/lib/qt6/bin/lupdate || command -v lupdate-qt6 || command -v lupdate) || {
  echo "lupdate is missing: install qt6-l10n-tools" >&2
  exit 77
}
# lupdate 6.8 takes the base of an `enum class` for that of the next structure. It then puts later texts into a wrong
# context. So it reads a copy without these bases.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r core drivers widgets app "$copy"
grep -rlZE 'enum class \w+ : ' "$copy" | xargs -0 -r sed -i -E 's/(enum class \w+) : [[:alnum:]_:]+/\1/'
for language in cs de; do
  file=$to/terratact_$language.ts
  [ "$to" = "$here" ] || cp "$here/terratact_$language.ts" "$file"
  (cd "$copy" && "$lupdate" -silent -no-obsolete -locations none -I . -source-language en -target-language $language \
    -tr-function-alias QT_TRANSLATE_NOOP+=TR_NOOP core drivers widgets app -ts "$file") 2>&1 |
    { grep -v 'Qualifying with unknown\|Ignoring definition' || true; }
done
