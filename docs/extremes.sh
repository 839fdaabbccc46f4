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
  TERRATACT_DRAWS=1000000000 "$build/tests/core.infer.sampling" --gtest_filter='*EveryOneOfManyDraws' | results
}
rows() {
  TERRATACT_ROWS=5600 "$build/tests/core.learn.gp" --gtest_filter="$many" | results
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
    awk '{ printf "%-24s %10.1f; the system'"'"'s own work, which cannot poll\n", "2 MiB never written to", $1
           printf "%-24s %10.1f; so is this, in pages of 4 KiB\n", "128 KiB never written to", $2 }'
}

show "ctest --test-dir $build -L extremes" tests
show "TERRATACT_DRAWS=1000000000 truncated_normal_test --gtest_filter='*EveryOneOfManyDraws'" draws
show "terratact-bench --benchmark_filter=^draws" per_draw
show "TERRATACT_ROWS=5600 gaussian_process_extremes_test --gtest_filter='$many'; TERRATACT_ROWS=5600 projected_process_test (same filter)" rows
show "terratact-bench --benchmark_filter='touchesOfFreshPages|cancelWaits'" cancelling
show "tests/core/infer/same_draws_test.py" /usr/bin/python3 -B tests/core/infer/same_draws_test.py
show "tests/core/infer/same_draws_test.py --native" /usr/bin/python3 -B tests/core/infer/same_draws_test.py --native

cat >docs/extremes.md <<END
# At the extremes

Every case gives a right answer or refuses with a text; none ends in a NaN or hangs.  \`ctest --preset headless -L extremes\` runs
all cases. \`docs/extremes.sh $build\` made this page. The long forms and their output are at the end.

| what | tests | long form |
|---|---|---|
| truncated normal draws | \`tests/core/infer/sampling/truncated_normal_test.cpp\` | \`TERRATACT_DRAWS=1000000000 build/headless/tests/core.infer.sampling --gtest_filter='*EveryOneOfManyDraws'\` |
| Gaussian processes against long double: exact ones, sparse ones (presets \`fast\` and \`balanced\`), both in single precision, too | \`tests/core/learn/gp/gaussian_process_extremes_test.cpp\`, \`sparse_process_test.cpp\` | \`TERRATACT_ROWS=5600 build/headless/tests/core.learn.gp --gtest_filter='*Sizes*'\` |
| surface processes (method \`local\`) against long double | \`tests/core/learn/gp/projected_process_test.cpp\` | \`TERRATACT_ROWS=5600 build/headless/tests/core.learn.gp --gtest_filter='*ofAModelsSize'\` |
| the likelihood and its gradient against long double | \`tests/core/learn/gp/likelihood_test.cpp\` | |
| estimates by all methods, cancelled at every poll, work between two polls | \`tests/core/infer/estimate_extremes_test.cpp\` | \`build/headless/tests/terratact-bench --benchmark_filter=cancelWaits\` (milliseconds on this machine) |
| robots and ground, also at every end of the ranges of pitch and flippers | \`tests/core/sim/rest/geometry_extremes_test.cpp\` | \`RC_PARAMS="seed=2 max_success=100000"\` before the test |
| same seed, same bytes | \`tests/core/infer/same_draws_test.py\` | \`python3 tests/core/infer/same_draws_test.py\` (four builds), \`--native\` (AVX kernels), \`--programs\` (what is built) |
| R-hat and ESS as the R package posterior | \`tests/core/infer/sampling/convergence_test.cpp\` | \`Rscript tests/data/make_posterior_reference.R\` writes the reference again |

The cost of a truncated normal draw: \`build/headless/tests/terratact-bench --benchmark_filter=draws\`.

**Same bytes.** The same seed gives the same draws, states and estimate with g++ and clang++. Optimisation level and number of threads do
not matter. This needs the same kernels (SSE4, AVX2 or AVX-512) and the same variants of the C library's functions. OpenBLAS must run in one
thread, as both programs set it.

**Singular models.** The covariance of the training rows may be singular to working precision. Then a jitter of 1e-10 to 1e-6 of its
diagonal is added and kept with the process. A model's file has hyperparameters and rows; the same jitter follows from them. An estimate
that used it has a warning, and \`terratact train\` prints one when it ends. A model that is singular even so is refused. The relative error
of an accepted model is 1e-14 over the reciprocal condition number, at most 1e-2. For a variance, it is relative to that of the prior. For a
mean, it is relative to the largest sum of its terms. That sum is about the largest output where outputs are as smooth as the length scales
(\`core/learn/gp/gaussian_process.h\`). Gaussian processes subtract inputs before they scale them, so length scales of 1e-8 separate rows
that are 1e-8 apart. Where the noise is less than that of the signal, a sparse process has a jitter of up to 1e-9. Its condition is the
same. The surface processes of \`local\` and \`joint\` always have a jitter of 1e-6 (\`core/learn/gp/projected_process.h\`). The same
condition refuses them in training.

**Constant chains.** R-hat of equal draws is undefined.  Such an estimate has not converged and has a warning. The exception
is a height at the bin's ceiling, which holds the draws there (\`core/infer/sampling/convergence.h\`).

**Cancelling.** An estimate polls for cancellation at least once per bin of a sweep (\`core/base/poll.h\`). It also polls

- every twenty million multiplications of a factorisation (\`core/learn/gp/cholesky.h\`),
- every 34 million of a sweep's sums of squares,
- every million numbers read,
- every 65536 draws or comparisons of a sort.

A thread that waits for another one to factorise the same bin polls every 5 ms. Closed forms poll while they draw, and the
choice of a probe polls, too. Training polls within every evaluation of a likelihood. Reading a model does not poll.

The system cannot poll while it gives memory or takes it back. Factors use pages of 2 MiB (\`core/learn/kernels/huge_pages.h\`);
training polls before each. On a virtual machine the host may have to find the memory first. The last lines of the table show
how long that takes; several such waits may lie between two polls. The factor of 5600 rows takes 120 such pages; a million
draws take 88 MB. A process may keep its memory (\`MALLOC_TRIM_THRESHOLD_=8000000000 MALLOC_MMAP_THRESHOLD_=4000000000\` before
the command). Then the waits of a million draws are those of arithmetic.

## Output of the long forms

$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1).  *first*: the first estimate with a model, which factorises its Gaussian processes;
*later*: an estimate after it.  Milliseconds of the processor between two polls.

\`\`\`
$(cat "$ran")
\`\`\`
END
