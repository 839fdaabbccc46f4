#!/usr/bin/env bash
# Writes docs/extremes.md: every test of extremes and its long form. Takes about twenty minutes.
# Usage: docs/extremes.sh [build directory]       default: build/headless
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/headless}
export OPENBLAS_NUM_THREADS=1
ran=$(mktemp)
waits=$(mktemp)
trap 'rm -f "$ran" "$waits"' EXIT

# Plain, doubled and collinear rows and a constant column, for the exact process and the sparse ones.
many='*Sizes.*/plain:*Sizes.*/doubledRows:*Sizes.*/collinear:*Sizes.*/constantColumn:*ofAModelsSize*'

# Prints a command and its output; a failure ends the script.
show() {
  what=$1
  shift
  printf '> %s\n' "$what" >>"$ran"
  "$@" >>"$ran" 2>&1 || { cat "$ran" >&2; exit 1; }
  echo >>"$ran"
}

# Prints the output of a test program without GoogleTest's standard lines.
results() {
  sed -n '/^\(Running main\|Note: \)/d; /^[^[]/p; /OK/p; /PASSED/p; /FAILED/p'
}
tests() {
  ctest --test-dir "$build" -L extremes -j "$(nproc)" | sed -n '/tests passed/p'
}
draws() {
  TERRATACT_DRAWS=1000000000 "$build/tests/core.infer.sampling.truncated_normal_test" --gtest_filter='*EveryOneOfManyDraws' | results
}
rows() {
  for test in gaussian_process_extremes_test projected_process_test; do
    TERRATACT_ROWS=5600 "$build/tests/core.learn.gp.$test" --gtest_filter="$many" | results || return 1
  done
}
per_draw() {
  "$build/tests/terratact-bench" --benchmark_filter=^draws 2>/dev/null | awk '/^draws/ { printf "%-40s %6.1f ns\n", $1, $4; if ($4 > most) most = $4 }
         END { printf "%-40s %6.1f ns; limit 150\n", "most", most }'
}
cancelling() {
  "$build/tests/terratact-bench" --benchmark_filter='touchesOfFreshPages|cancelWaits' >"$waits" 2>/dev/null
  sed -n 's/^cancelWaits.*first_ms=\([^ ]*\) later_ms=\([^ ]*\) \(.*\)/\1 \2 \3/p' "$waits" |
    awk 'BEGIN { printf "%-24s %10s %10s\n", "ms", "first", "later" }
         { what = $3; for (i = 4; i <= NF; ++i) what = what " " $i; printf "%-24s %10.1f %10.1f\n", what, $1, $2
           if ($1 > most) most = $1; if ($2 > most) most = $2 }
         END { printf "%-24s %10.1f; limit 20\n", "most", most }'
  sed -n 's/^touchesOfFreshPages.* 128_KiB_ms=\([^ ]*\) 2_MiB_ms=\([^ ]*\).*/\2 \1/p' "$waits" |
    awk '{ printf "%-24s %10.1f; the system'"'"'s own work, in which nothing can be asked\n", "2 MiB never written to", $1
           printf "%-24s %10.1f; so is this, in pages of 4 KiB\n", "128 KiB, likewise", $2 }'
}

show "ctest --test-dir $build -L extremes" tests
show "TERRATACT_DRAWS=1000000000 truncated_normal_test --gtest_filter='*EveryOneOfManyDraws'" draws
show "terratact-bench --benchmark_filter=^draws" per_draw
show "TERRATACT_ROWS=5600 gaussian_process_extremes_test --gtest_filter='$many'; TERRATACT_ROWS=5600 projected_process_test, likewise" rows
show "terratact-bench --benchmark_filter='touchesOfFreshPages|cancelWaits'" cancelling
show "tests/core/infer/same_draws_test.py" /usr/bin/python3 -B tests/core/infer/same_draws_test.py
show "tests/core/infer/same_draws_test.py --native" /usr/bin/python3 -B tests/core/infer/same_draws_test.py --native

cat >docs/extremes.md <<END
# At the extremes

Every case answers right or refuses with a text; none ends in a NaN or hangs.  \`ctest --preset headless -L extremes\` runs
them all; \`docs/extremes.sh $build\` made this page, with the long forms and what they said, at the end.

| what | tests | long form |
|---|---|---|
| truncated normal draws | \`tests/core/infer/sampling/truncated_normal_test.cpp\` | \`TERRATACT_DRAWS=1000000000 build/headless/tests/core.infer.sampling.truncated_normal_test --gtest_filter='*EveryOneOfManyDraws'\` |
| Gaussian processes against long double: exact ones, sparse ones (presets \`fast\` and \`balanced\`), both in single precision, too | \`tests/core/learn/gp/gaussian_process_extremes_test.cpp\`, \`sparse_process_test.cpp\` | \`TERRATACT_ROWS=5600 build/headless/tests/core.learn.gp.gaussian_process_extremes_test --gtest_filter='*Sizes*'\` |
| surface processes (method \`local\`) against long double | \`tests/core/learn/gp/projected_process_test.cpp\` | \`TERRATACT_ROWS=5600 build/headless/tests/core.learn.gp.projected_process_test --gtest_filter='*ofAModelsSize'\` |
| the likelihood and its gradient against long double | \`tests/core/learn/gp/likelihood_test.cpp\` | |
| estimates by all methods, cancelled at every question, work between two questions | \`tests/core/infer/estimate_extremes_test.cpp\` | \`build/headless/tests/terratact-bench --benchmark_filter=cancelWaits\` (milliseconds on this machine) |
| robots and ground, also at every end of the ranges of pitch and flippers | \`tests/core/sim/geometry_extremes_test.cpp\` | \`RC_PARAMS="seed=2 max_success=100000"\` before the test |
| same seed, same bytes | \`tests/core/infer/same_draws_test.py\` | \`python3 tests/core/infer/same_draws_test.py\` (four builds), \`--native\` (AVX kernels), \`--programs\` (what is built) |
| R-hat and ESS as the R package posterior | \`tests/core/infer/sampling/convergence_test.cpp\` | \`Rscript tests/data/make_posterior_reference.R\` writes the reference anew |

What a truncated normal draw costs: \`build/headless/tests/terratact-bench --benchmark_filter=draws\`.

**Same bytes.** The same seed gives the same draws, states and estimate with g++ and clang++, at every optimisation and
with any number of threads, as long as the processor picks the same kernels (SSE4, AVX2 or AVX-512) and the same
variants of the C library's functions, and OpenBLAS runs in one thread, as both programs set it.

**Singular models.** Where the covariance of the training rows is singular to working precision, a jitter of 1e-10 to
1e-6 of its diagonal is added and kept with the process (a model's file has hyper-parameters and rows, from which the same jitter
comes again); an estimate that used it says so among its warnings, \`terratact train\` when it ends. A model that
this does not mend is refused. What is accepted is right to 1e-14 over the reciprocal condition number, at most 1e-2: a
variance of the prior's, a mean of the most that its terms could add up to, which is about the largest output where
outputs vary as smoothly as the length scales say (\`core/learn/gp/gaussian_process.h\`). Gaussian processes take differences of inputs
before they scale them, so rows 1e-8 apart are told apart at length scales of 1e-8. A sparse process has a jitter of up to 1e-9 where the noise is less than that of the signal, and
the same condition. The surface processes of \`local\` and \`joint\` always have a jitter of 1e-6
(\`core/learn/gp/projected_process.h\`) and are refused by the same condition when they are trained.

**Chains that stand still.** R-hat of draws that are all the same is undefined.  Such an estimate has not converged,
and says so, unless the height is the bin's ceiling, which holds the draws there (\`core/infer/sampling/convergence.h\`).

**Cancelling.** An estimate asks whether it is still wanted at least once per bin of a sweep, and in between every
twenty million multiplications of a factorisation (\`core/learn/gp/cholesky.h\`), every 34 million of a sweep's sums of
squares, every million numbers read, and every 65536 draws, comparisons of a sort or the like (\`core/base/poll.h\`). So do
a thread that waits for another one to factorise the same bin (every 5 ms), closed forms while they draw, the advice
where to probe, and training within every evaluation of a likelihood. Reading a model does not ask. What cannot ask is the system, when it gives memory (in pages of 2 MiB for
factors, \`core/learn/kernels/huge_pages.h\`; training asks before each) or takes it back: a virtual machine whose host has to find the memory first may stand still for
as long as the table's last lines say, and longer where several such waits lie between two questions.  The factor of 5600 rows takes
120 such pages; a million draws take 88 MB. With memory that the process keeps (\`MALLOC_TRIM_THRESHOLD_=8000000000
MALLOC_MMAP_THRESHOLD_=4000000000\` before the command) the waits of a million draws are those of arithmetic.

## What the long forms said

$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1).  *first*: an estimate with a model that has not been used before, whose Gaussian processes
are factorised on the way; *later*: one after it.  Milliseconds of the processor between two questions.

\`\`\`
$(cat "$ran")
\`\`\`
END
