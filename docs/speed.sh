#!/bin/sh
# Writes docs/speed.md.
# Usage: docs/speed.sh [build directory] [rounds]       default: build/headless 3
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/headless}
rounds=${2:-3}
before=$(cut -d' ' -f1 /proc/loadavg)
table=$(mktemp)
training=$(mktemp)
trap 'rm -f "$table" "$training"' EXIT
tests/bench/run.sh "$build" "$rounds" >"$table"
tests/bench/training.sh "$build" >"$training"
cat >docs/speed.md <<END
# What sampling and training cost

\`docs/speed.sh $build $rounds\` made this page; it runs \`tests/bench/run.sh $build $rounds\`.  That runs the sampler and the same work in
NumPy and SciPy (\`tests/bench/peer_numpy.py\`) in turns. It uses one thread and measures processor time.  NumPy has the fastest kernels
that its OpenBLAS offers for this processor.  Debian 12's does not always find them by itself (\`tests/bench/peer_blas.py\`). Compare
ratios, because times depend on the machine and the hour.  Other programs on its cores change what the caches hold. NumPy needs more of the
caches, so more load makes the ratios to NumPy larger.  Load average before and after: $before, $(cut -d' ' -f1 /proc/loadavg).

Highway compiles our kernels for several instruction sets from one source (\`core/learn/kernels/kernel_targets.h\`).  The program uses the
fastest set that the processor has.  The tables show AVX-512, AVX2 and SSE4, as far as the processor has them.  They leave out SSSE3 and the
baseline of older processors.  On a processor without these sets, such as one of ARM, they show its baseline alone.

A *chain-sweep* draws nine unknown bins of one chain once, from processes of 1400 rows.  *Scenes of an evaluation* have
their own known bins and 20 sweeps per chain.  They include all the work of \`evaluate\` and \`reconstruct\`.
*rows*: 16 chains through so many inducing rows; \`fast\`, \`balanced\` and \`accurate\` are the presets.

\`\`\`
$(cat "$table")
\`\`\`

## Many scenes

Every scene uses the same eleven Gaussian processes.  Scenes differ only in the weights of what is known and in which inputs
move.  Both are in the covariances, computed for eight columns at a time.  The packed factor \`L⁻¹\` is common.  The chains
of several scenes, 64 columns together, therefore go through it in one pass (\`EstimateBatch\`, \`core/infer/estimate_batch.h\`).
The factor is read from memory once for all.  The columns of two scenes fill a group of eight that either would leave half
empty.  A scene that knows a bin is left out there.  A scene that has converged leaves, and the next enters.  Every estimate
is that of the scene alone, bit for bit, on any number of processors (\`tests/core/infer/estimate_batch_test.cpp\`, \`tests/cli/commands_test.py\`).

The gain is large with few chains, where groups are not full.  There is none,
within the variation of the table, where groups are full and factors fit the caches without it.  That holds for inducing rows,
the presets fast and balanced: such scenes stay alone.  Scenes with a random scan stay alone, because each has its own order
of bins.  Scenes with a limit of seconds stay alone, too, because the limit is that of a thread with one scene.

## What a sweep saves, and what limits the rest

Most training rows add little to others. Given well chosen rows, the remaining variance of a row is far below the noise. In single precision
a variance therefore goes through selected rows (\`core/learn/gp/sparse_process.h\`).  They leave no other row more than 1e-4 of the noise's
variance, and all others together no more than 1 %.  They are chosen when a process is first used; the table shows how many of the products
are left.  A mean goes through all rows, in double.  The result is compared with all rows where a process is first used.  It is not used
where a variance is off by more than 0.2 % at sixteen probes.  This command prints how far variances of the shipped model are off, from
likely to absurd states: \`$build/tests/core.learn.model --gtest_filter='*SinglePrecision*'\`.  In double nothing is
left out.

*quadratic form*: measured with one bin's factor of all rows, which the nearest caches keep in part.  *rest*: the extra cost of nine bins'
factors (smaller and farther away), of standardising, and of keeping draws.

A peer in double computes twice as many vectors for the same numbers. It computes whole squares where a triangle would do.  Its share of the
peak in double shows how much of a ratio that is.  One scene makes as many sweeps in NumPy as here.  Its ratio is that of chain-sweeps, less
the cost of summarising.  AVX2 against AVX-512 is bounded by the ratio of their peaks, if both reach the same share.

## Training

By \`tests/bench/training.sh $build\`, on generated scenes.  *train*: hyperparameters of the paper's 22 processes, on two
cores.  *growth*: one evaluation of likelihood and gradient, and the largest memory of the program.  The memory is in doubles and in
multiples of the rows' square.  *sparse*: one bin's process.  Hyperparameters are searched for on some rows or on all.  Then
the process is made of all rows (\`through\` as many) or through inducing rows, and predicts 5000 unseen scenes.  \`terratact
train\` searches on all rows, with up to 30 such evaluations; with \`--inducing\`, on 1400.  *sparse-bins*: the error through so many rows as a share of that through all, of every bin.

\`\`\`
$(cat "$training")
\`\`\`
END
