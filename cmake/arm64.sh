#!/usr/bin/env bash
# Cross-builds for arm64 in a clean Debian of this machine's architecture. Tests there under qemu-user. Needs root and a
# network:
#   cmake/arm64.sh [bookworm|trixie] [package] [tests] [numbers]      default: bookworm; without names: all
#   package  builds the arm64 package; lintian, apt-get install, both programs, apt-get purge
#   tests    builds and runs the tests of the core, without those that $slow names
#   numbers  estimates the same scenes by the arm64 program and by $BESIDE, a `terratact` of this machine; prints
#            the largest differences
# It builds the committed files. The Debian is in $ROOT, else build/arm64/root-RELEASE, and is used again. build/arm64 has
# the package, SHA256SUMS, the logs, the pictures, and table.txt, the steps with their seconds. If $CCACHE_DIR is set,
# compilers keep their results there.
set -euo pipefail
debian=bookworm
case ${1:-} in bookworm | trixie) debian=$1 && shift ;; esac
[ $# != 0 ] || set -- package tests ${BESIDE:+numbers}
for name; do
  case $name in
  package | tests) ;;
  numbers) [ -x "${BESIDE:-}" ] || { echo "arm64.sh: numbers needs BESIDE=PROGRAM, a terratact of this machine" >&2; exit 2; } ;;
  *) echo "arm64.sh: unknown name '$name' (package, tests, numbers)" >&2; exit 2 ;;
  esac
done
[ -z "${BESIDE:-}" ] || BESIDE=$(realpath "$BESIDE")
cd "$(dirname "$0")/.."
out=$PWD/build/arm64
log=$out/arm64.log
. cmake/clean_root.sh
release=$debian
emulator=qemu-aarch64-static
build=$sources/build/package
# Tests that qemu makes too slow: they train many models, or models of 1400 rows, or compare with long double, which
# arm64 computes in software.
slow='MissingSensors.*:BinModels.shippedModelKeepsItsSinglePrecisionBounds:SceneCopies.bandsHoldTheTruthAsOftenAfterDoubling'
slow+=':ModelFile.everyBitFlipIsRefusedOrChangesNothing:ManyRows/Sizes.ofAModelEqualLongDouble/*'
version=$(cmake/version.sh)
begin_table "$out"
: >"$log"

configure() {
  inside cmake -S $sources --preset package -D CMAKE_TOOLCHAIN_FILE=$sources/cmake/arm64.cmake -D TERRATACT_TESTS=ON \
    -D TERRATACT_PACKAGE_VERSION="$version" ${HOMEPAGE:+-D TERRATACT_HOMEPAGE="$HOMEPAGE"} \
    ${MAINTAINER:+-D CPACK_PACKAGE_CONTACT="$MAINTAINER"}
}

built() { inside cmake --build $build --parallel "$(nproc)" --target "$@"; }

# Prints the targets of the tests of the core: core.base, core.atem.panel_test, …
core_tests() { inside ninja -C $build -t targets all | sed -n 's/^\(core\.[a-z0-9_.]*\): phony$/\1/p' | sort -u; }

# DEB_HOST_ARCH makes dpkg-shlibdeps look for arm64's libraries.
make_package() {
  rm -f "$out"/terratact_*.deb
  inside sh -c "cd $build && DEB_HOST_ARCH=arm64 cpack -G DEB"
  cp "$root$build"/terratact_*_arm64.deb "$out/"
  (cd "$out" && sha256sum -- terratact_*_arm64.deb >SHA256SUMS)
}

describe_package() { dpkg-deb -f "$out"/terratact_*_arm64.deb Version Architecture Depends | tee -a "$log"; }

install_package() {
  cp "$out"/terratact_*_arm64.deb "$root/tmp/terratact.deb"
  inside apt-get -q -y install --no-install-recommends /tmp/terratact.deb
  rm "$root/tmp/terratact.deb"
}

# Each entry is a program of tests.
run_tests() {
  inside env OPENBLAS_NUM_THREADS=1 GTEST_FILTER="-$slow" ctest --test-dir $build -R '^core/' -j "$(nproc)" \
    --output-on-failure
}

# Prints how many programs passed, and how many of their tests.
count_tests() {
  cp "$root$build/Testing/Temporary/LastTest.log" "$out/tests.log"
  grep 'tests passed' "$log"
  sed -n -E 's/^\[  (PASSED|SKIPPED) *\] ([0-9]+) tests?(\.|, listed below:)$/\1 \2/p' "$out/tests.log" |
    awk '{ count[$1] += $2 } END { printf "%d tests passed, %d were skipped\n", count["PASSED"], count["SKIPPED"] }'
}

# Both programs drive the simulated robot. The other program trains a small model: to factorise the shipped one takes
# minutes under qemu.
simulate() {
  local folder=$root/home/operator
  as_user $build/app/terratact simulate --terrain boxes --count 100 --out scenes.csv
  mv "$folder/scenes.csv" "$out/arm64_scenes.csv"
  "$BESIDE" simulate --terrain boxes --count 100 --out "$out/beside_scenes.csv"
  "$BESIDE" train --data "$out/beside_scenes.csv" --out "$out/model.ttm"
  cp "$out/beside_scenes.csv" "$out/model.ttm" "$folder/"
}

# estimate METHOD: estimates these scenes by both programs, as the console does.
estimate() {
  local options=(reconstruct --quality balanced --method "$1" --model model.ttm --data beside_scenes.csv)
  as_user $build/app/terratact "${options[@]}" --out "arm64_$1.csv"
  cp "$root/home/operator/arm64_$1.csv" "$out/"
  (cd "$out" && "$BESIDE" "${options[@]}" --out "beside_$1.csv")
}

# differences FILE FILE: prints how many numbers and words of two CSV files differ. Of each column of numbers it prints
# the largest difference.
differences() {
  awk -F , -v name="$(basename "$1" .csv)" '
    function number(x) { return x ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/ }
    NR == FNR { row[FNR] = $0; next }
    FNR == 1 { split($0, title); next }
    { n = split(row[FNR], other)
      for (k = 1; k <= n; ++k) {
        if (!number($k) || !number(other[k])) { text += $k != other[k]; continue }
        d = $k - other[k]; if (d < 0) d = -d
        ++all; some += d > 0
        if (d > largest[k] + 0) largest[k] = d } }
    END {
      printf "%s: %d of %d numbers and %d words differ", name, some, all, text
      for (k = 1; k <= n; ++k) if (largest[k] > 0) printf ", %s %.0e", title[k], largest[k]
      printf "\n" }' "$1" "$2"
}

make_root "${ROOT:-$out/root-$release}"
inside dpkg --add-architecture arm64
copy_sources
step "setup.sh --arch arm64" inside $sources/cmake/setup.sh --arch arm64 core gui unit package
step "configure" configure
step "build terratact" built terratact
for name; do
  case $name in
  package)
    step "build terratact-console" built terratact-console
    step "cpack" make_package
    describe_package
    step "lintian" lintian --allow-root --fail-on error,warning "$out"/terratact_*_arm64.deb
    step "apt-get install" install_package
    try_programs /usr/bin/
    step "apt-get purge" inside apt-get -q -y purge terratact ;;
  tests)
    # shellcheck disable=SC2046
    step "build the tests of the core" built $(core_tests)
    step "tests of the core" run_tests
    count_tests ;;
  numbers)
    step "simulate" simulate
    differences "$out/arm64_scenes.csv" "$out/beside_scenes.csv" | tee "$out/numbers.txt"
    for method in local clearance joint pafac; do
      step "reconstruct --method $method" estimate $method
      differences "$out/arm64_$method.csv" "$out/beside_$method.csv" | tee -a "$out/numbers.txt"
    done ;;
  esac
done
remove_root
steps_table | tee "$out/table.txt"
