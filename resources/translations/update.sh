#!/usr/bin/env bash
# Brings the translations up to the sources: new texts arrive unfinished, those no longer used leave.
#   resources/translations/update.sh [DIR]   writes into DIR instead of here
# Then fill them in (Qt Linguist, or an editor) and run the test app/translations_test.
set -euo pipefail
cd "$(dirname "$0")/../.."
here=resources/translations
to=${1:-$here}
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
[ -x "$lupdate" ] || {
  echo "lupdate is missing: install qt6-l10n-tools" >&2
  exit 77
}
for language in cs de; do
  file=$to/terratact_$language.ts
  [ "$to" = "$here" ] || cp "$here/terratact_$language.ts" "$file"
  "$lupdate" -silent -no-obsolete -locations none -I . -source-language en -target-language $language \
    -tr-function-alias QT_TRANSLATE_NOOP+=TR_NOOP core drivers widgets app -ts "$file" 2>&1 | grep -v 'Qualifying with unknown\|Ignoring definition' || true
done
