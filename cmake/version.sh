#!/usr/bin/env bash
# Prints the version of a package built from these sources:
#   0.2.0           the project's version in CMakeLists.txt: at the tag v0.2.0, without any tag, and without git
#   0.2.0+7.g1a2b3  seven commits after the tag v0.2.0
#   0.3.0~7.g1a2b3  the same if CMakeLists.txt already names the next version
# A tag at this commit must name the project's version.
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^project(Terratact VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
[ -n "$version" ] || { echo "version.sh: CMakeLists.txt names no version" >&2; exit 1; }
told=
if [ -e .git ]; then
  git rev-parse HEAD >/dev/null || { echo "version.sh: git does not read this repository: see above" >&2; exit 1; }
  told=$(git describe --tags --long --match 'v[0-9]*' 2>/dev/null || true)
fi
if [[ "$told" =~ ^v(.*)-([0-9]+)-(g[0-9a-f]+)$ ]]; then
  tag=${BASH_REMATCH[1]} commits=${BASH_REMATCH[2]} commit=${BASH_REMATCH[3]}
  if [ "$commits" = 0 ] && [ "$tag" != "$version" ]; then
    echo "version.sh: the tag is v$tag, but CMakeLists.txt says $version: expected the same" >&2
    exit 1
  fi
  if [ "$tag" = "$version" ]; then [ "$commits" = 0 ] || version+=+$commits.$commit; else version+=~$commits.$commit; fi
fi
echo "$version"
