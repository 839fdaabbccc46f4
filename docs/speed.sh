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

Made by \`docs/speed.sh $build $rounds\`, which runs \`tests/bench/run.sh $build $rounds\`: the sampler and the same work
in NumPy and SciPy (\`tests/bench/peer_numpy.py\`) in turns, on one thread, in processor time.  NumPy has the fastest kernels that
its OpenBLAS offers for this processor, which Debian 12's does not always find by itself (\`tests/bench/peer_blas.py\`).
Take ratios: times are of this machine and this hour, and other programs on its cores change what the caches hold: the
more, the larger the ratios to NumPy, which needs more of them.  Load average before and after: $before, $(cut -d' ' -f1 /proc/loadavg).

A *chain-sweep* draws nine unknown bins of one chain once, from processes of 1400 rows.  *Scenes of an evaluation* have
their own known bins, 20 sweeps per chain, and everything around them: what \`evaluate\` and \`reconstruct\` do.
*rows*: 16 chains through so many inducing rows; \`fast\`, \`balanced\` and \`accurate\` are the presets.

\`\`\`
$(cat "$table")
\`\`\`

## Many scenes

Every scene asks the same eleven Gaussian processes.  Its own are only the weights of what is known and which inputs
move; both are in the covariances, computed for eight columns at a time.  The packed factor \`L⁻¹\` is common, so the chains
of several scenes, 64 columns together, go through it in one pass (\`EstimateBatch\`, \`core/infer/estimate_batch.h\`): it is read
from memory once for all, and the columns of two scenes fill a group of eight that either would leave half empty.  A scene that
knows a bin takes no part there; one that has converged leaves, and the next enters.  Every estimate is that of the scene alone,
bit for bit, on any number of processors (\`tests/core/infer/estimate_batch_test.cpp\`, \`tests/cli/commands_test.py\`).

The gain is large with few chains, where groups are not full.  It is none, within what the table varies from run to run,
where groups are full and factors fit the caches without it (inducing rows, the presets fast and balanced): such scenes stay
alone.  So do those with a random scan, where each scene has its own order of bins, and those with a limit of seconds, which
is of a scene that has its thread alone.

## What a sweep saves, and what limits the rest

Most training rows say little that others do not: given well chosen ones, what is left of a row's variance is next to
nothing of the noise.  In single precision a variance therefore goes through the rows that leave no other more than
1e-4 of the noise's variance, and all others together no more than 1 % (\`core/learn/gp/sparse_process.h\`), chosen when a process is first used; the table says how many of
the products are left.  A mean goes through all rows, in double.  What comes of it is compared with
all rows where a process is first used, and not used where a variance is off by more than 0.2 % at sixteen probes.  How far variances of the
shipped model are off, from likely to absurd states, is printed by
\`build/headless/tests/core.learn.model.bin_models_test --gtest_filter='*SinglePrecision*'\`.  In double nothing is left out.

*quadratic form*: as measured with one bin's factor of all rows, which the nearest caches keep in part; *rest*: what nine bins'
factors cost more by coming from farther away and being smaller, standardising, and keeping draws.

A peer that works in double computes twice as many vectors for the same numbers, and whole squares where a triangle would do;
what it makes of the peak in double says how much of a ratio is that.  One scene makes as many sweeps in NumPy as here, so its
ratio is that of chain-sweeps, less what summarising costs.
AVX2 against AVX-512 is bounded by the ratio of their peaks, as long as both are as near to their own.

## Training

By \`tests/bench/training.sh $build\`, on generated scenes.  *train*: hyper-parameters of the paper's 22 processes, on two
cores.  *growth*: one evaluation of likelihood and gradient, and the memory that the program came to need, in doubles and in
multiples of the rows' square.  *sparse*: one bin's process; hyper-parameters are searched for on some rows or on all, then the process is made
of all rows (\`through\` as many) or through inducing rows, and predicts 5000 unseen scenes.  \`terratact train\` searches on all
rows, with up to 30 such evaluations, unless it is told \`--inducing\`: then on 1400.  *sparse-bins*: the error through so many rows as a share of that through all, of every bin.

\`\`\`
$(cat "$training")
\`\`\`
END
