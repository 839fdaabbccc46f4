#pragma once

#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

/// The two hot loops of training, compiled for several instruction sets from one source by Highway.
/// All pointers must be 64-byte aligned unless stated otherwise.
///
/// Rows are packed in groups of kGroup: group g holds rows 8g … 8g + 7 of a matrix M as
///   packed[g · stride + k · kGroup + r] = M[8g + r][k].
struct LikelihoodKernels {
    const char* name;  ///< of the instruction set, see nameOfTarget()

    /// Computes C −= A Bᵀ for one tile of kGroup × kTileColumns: A is one group, B three of them,
    /// `length` products.
    ///   C[r · rowStride + (c / 8) · groupStride + c % 8]
    void (*subtractProducts)(const double* A, const double* B, long stride, int length, double* C,
                             long rowStride, long groupStride);

    /// Adds weighted squares for one row of a symmetric matrix G = (−N − α αᵀ) ∘ S. c runs over its
    /// first `columns` entries (a multiple of 8). Each sum is kept as 8 partial sums; sums: (m + 1) × 8.
    ///   sums[d] += Σ_c G_c (x[d] − Z[d · stride + c])²  for d < m
    ///   sums[m] += Σ_c G_c
    ///   N, S: the row, `columns` entries; alphaOfRow: α of the row; alpha: of the columns;
    ///   x: m (any alignment), Z: m × stride.
    void (*addWeightedSquares)(const double* N, const double* S, double alphaOfRow,
                               const double* alpha, int columns, const double* x, const double* Z,
                               long stride, int m, double* sums);
};

inline constexpr int kTileColumns = 24;

/// Returns the fastest kernels that this processor runs.
const LikelihoodKernels& likelihoodKernels();

/// Returns every variant that this processor runs, fastest first, for tests and benchmarks. count:
/// their number. The array lives as long as the program.
const LikelihoodKernels* const* availableLikelihoodKernels(int& count);

}  // namespace terratact
