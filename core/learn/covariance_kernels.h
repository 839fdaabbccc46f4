#pragma once

namespace terratact {

/// The two loops that everything else waits for, compiled for several instruction sets from one source
/// (covariance_kernels.inl).  All pointers 64-byte aligned, all sizes in doubles.
struct CovarianceKernels {
    const char* name;  ///< "AVX-512", "AVX2", "baseline"

    /// K[u·C + c] = signal² exp(logWeight[u] − ½ Σ_j (X[u·m + j] − Z[j·C + c])²)
    /// for u < U, c < C.  C must be a multiple of 8.  X and Z are in length scales.
    void (*covariances)(const double* X, const double* logWeight, const double* Z, int U, int m,
                        int C, double signal2, double* K);

    /// out[c] = Σ_i (Σ_{j ≤ i} T[i][j] K[j·C + c])² for a lower triangle T packed in panels of
    /// kPanelRows rows (see packTriangle).  U and C must be multiples of 8.
    void (*sumsOfSquares)(const double* panels, const double* K, int U, int C, double* out);
};

inline constexpr int kPanelRows = 8;

/// Fastest kernels this processor runs.
const CovarianceKernels& covarianceKernels();

/// Every variant this processor runs, fastest first (for tests and benchmarks).
/// count: how many; the array lives as long as the program.
const CovarianceKernels* const* availableCovarianceKernels(int& count);

}  // namespace terratact
