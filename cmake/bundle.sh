#!/usr/bin/env bash
# Makes a folder of Debian 12's package and the libraries it needs, for other distributions; needs root and a network:
#   cmake/bundle.sh PACKAGE~deb12_amd64.deb             build/bundle/terratact-VERSION-x86_64.tar.xz
#   cmake/bundle.sh --check BUNDLE.tar.xz [RELEASE]     unpacks it in a clean root, and a user runs both programs
# It runs where glibc is at least 2.36 (Debian 12). The system has these libraries of its own: glibc, libstdc++, OpenGL
# (libGL, libEGL), which belongs to the graphics driver, and ALSA, which belongs to the sound server; and a font.
# It is meant for Ubuntu and Fedora on amd64, and was not tried on Fedora: docs/packages.md.
# RELEASE is a release of Debian or, with a mirror in MIRROR and DEBOOTSTRAP=--keyring=FILE, of Ubuntu.
set -euo pipefail
check=
[ "${1:-}" != --check ] || { check=yes && shift; }
[ $# -ge 1 ] || { sed -n '2,4s/^# \{0,1\}//p' "$0" >&2; exit 2; }
set -- "$(realpath "$1")" "${@:2}"
cd "$(dirname "$0")/.."
out=$PWD/build/bundle
mkdir -p "$out"
log=$out/bundle${check:+_check}.log
. cmake/clean_root.sh
: >"$log"

# Fills /bundle in the root, where the package is installed. The programs find their files at ../share/terratact. Qt
# finds its plugins by bin/qt.conf. Programs and libraries find their libraries relative to themselves.
fill_bundle() {
  inside bash -euo pipefail -c '
    mkdir -p /bundle/bin /bundle/lib/plugins
    cp /usr/bin/terratact /usr/bin/terratact-console /bundle/bin
    cp -r --parents /usr/share/terratact /usr/share/doc/terratact /usr/share/man/man1/terratact*.1.gz \
      /usr/share/applications/org.terratact.* /usr/share/icons/hicolor/scalable/apps/org.terratact.* /bundle
    mv /bundle/usr/share /bundle && rmdir /bundle/usr
    cd /usr/lib/*/qt6/plugins
    cp -r --parents platforms/libqxcb.so platforms/libqoffscreen.so platforms/libqwayland-*.so iconengines imageformats \
      platforminputcontexts wayland-decoration-client wayland-shell-integration xcbglintegrations /bundle/lib/plugins
    printf "[Paths]\nPrefix=..\nPlugins=lib/plugins\nTranslations=share/qt6/translations\n" >/bundle/bin/qt.conf
    cp -r --parents /usr/share/qt6/translations/qtbase_{cs,de}.qm /bundle
    cp -r /bundle/usr/share/qt6 /bundle/share && rm -r /bundle/usr
    system="lib(c|m|dl|pthread|rt|resolv|stdc\+\+|gcc_s|GL|EGL|GLX|OpenGL|GLdispatch|asound)\.so"
    find /bundle/bin /bundle/lib -type f ! -name qt.conf -exec ldd {} + | sed -n "s/.* => \(\/[^ ]*\) .*/\1/p" | sort -u |
      grep -vE "/$system" | xargs cp -L -t /bundle/lib
    for file in /bundle/bin/terratact*; do patchelf --set-rpath "\$ORIGIN/../lib" $file; done
    for file in /bundle/lib/*.so*; do patchelf --set-rpath "\$ORIGIN" $file; done
    find /bundle/lib/plugins -name "*.so" -exec patchelf --set-rpath "\$ORIGIN/../.." {} +
    # Licences of the libraries, as their packages have them.
    mkdir /bundle/share/doc/libraries
    for file in /bundle/lib/*.so*; do dpkg -S "*/${file##*/}" | cut -d : -f 1; done | sort -u |
      while read -r package; do cp -L /usr/share/doc/$package/copyright /bundle/share/doc/libraries/$package; done'
}

pack() {
  local name=terratact-$1-x86_64
  mv "$root/bundle" "$root/$name"
  rm -f "$out/$name.tar.xz"
  XZ_OPT="-2 -T0" tar -C "$root" --sort=name --owner=0 --group=0 -cJf "$out/$name.tar.xz" "$name"
  (cd "$out" && sha256sum "$name.tar.xz" >SHA256SUMS)
}

if [ -n "$check" ]; then
  release=${2:-trixie}
  make_root
  sound=libasound2t64
  inside apt-cache show $sound >/dev/null 2>&1 || sound=libasound2
  step "apt-get install what a desktop has" inside apt-get -q -y install --no-install-recommends \
    libgl1 libegl1 libopengl0 $sound fonts-dejavu-core
  step "unpack" tar -C "$root/opt" -xf "$1" --transform 's|^[^/]*|terratact|'
  try_programs /opt/terratact/bin/
  echo "passed: $(basename "$1") runs on $release (log: $log)"
else
  release=bookworm
  make_root
  cp "$1" "$root/tmp/terratact.deb"
  step "apt-get install the package, Qt's plugins and translations, patchelf" inside apt-get -q -y install \
    --no-install-recommends /tmp/terratact.deb qt6-wayland qt6-translations-l10n patchelf
  step "copy programs and libraries" fill_bundle
  version=$(dpkg-deb -f "$1" Version)
  step "pack" pack "${version%\~*}"
  ls -l "$out"/terratact-*.tar.xz
fi
