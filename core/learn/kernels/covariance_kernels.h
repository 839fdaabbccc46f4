#pragma once

namespace terratact {

/// Predictions are computed for this many columns (chains) at a time.
inline constexpr int kGroup = 8;

/// Groups that hold so many columns.
constexpr int groupsOf(int columns)
{
    return (columns + kGroup - 1) / kGroup;
}

/// Rows of L⁻¹ in one panel: 192 bytes.
template <class T>
inline constexpr int kPanelRows = 192 / static_cast<int>(sizeof(T));

/// In units of signal²: what is less counts as 0 in single precision, lest it were subnormal.
inline constexpr double kMinSingleCovariance = 1e-30;

/// Covariances with the training rows at one setting of 8 columns, and what they are multiplied with.
struct CovarianceInput {
    const double* X = nullptr;          ///< U × m, row-major
    const double* perLength = nullptr;  ///< m: 1 / ℓ
    const double* logWeight = nullptr;  ///< U
    const double* alpha = nullptr;      ///< U
    int U = 0;
    int kept = 0;  ///< at most U: the first rows, whose covariances are written
    int m = 0;
    double signal2 = 1.0;
};

/// What a kernel calls every few milliseconds; may throw.  Not a std::function, whose code would be shared between
/// instruction sets.
struct KernelPoll {
    void (*call)(const void* context) = nullptr;
    const void* context = nullptr;
};

/// Multiplications of a kernel between two polls, give or take a panel's.
inline constexpr long kKernelMultiplications = 1L << 25;

/// The loops that everything else waits for, compiled for several instruction sets from one source
/// (covariance_kernels.inl).  All pointers 64-byte aligned.  A column's result does not depend on the columns
/// beside it; AVX-512 and AVX2 give the same bits, for both use fused products in the same order.
struct CovarianceKernels {
    const char* name;  ///< "AVX-512", "AVX2", "baseline"

    /// K[u·8 + c] = signal² exp(logWeight[u] − ½ Σ_j ((X[u·m + j] − Z[j·8 + c]) perLength[j])²), u < kept,
    /// c < 8, the exponent at least −300; mean[c] = Σ_u K[u·8 + c] alpha[u], u < U.  Z: m × 8.
    /// Differences are scaled, not inputs: those round by 2⁻⁵³ |x| / ℓ length scales, which is much where ℓ is tiny.
    void (*covariances)(const CovarianceInput& in, const double* Z, double* K, double* mean);
    /// The same, K rounded to float; the mean is summed before that.
    void (*covariancesSingle)(const CovarianceInput& in, const double* Z, float* K, double* mean);

    /// out[g·8 + c] = Σ_{i < U} (Σ_{j ≤ i} T[i][j] K_g[j·8 + c])², c < 8, for `groups` blocks K_g, each
    /// paddedRows(U) × 8 and zero from row U on, one behind the other; a lower triangle T in panels.
    void (*sumsOfSquares)(const double* panels, const double* K, int U, int groups, double* out,
                          KernelPoll poll);
    /// The same with products and squares in float; the last sum over 16 is double.
    void (*sumsOfSquaresSingle)(const float* panels, const float* K, int U, int groups, double* out,
                                KernelPoll poll);
};

/// Rows of a block of covariances: U, to full panels of either precision.
constexpr int paddedRows(int U)
{
    return (U + kPanelRows<float> - 1) / kPanelRows<float> * kPanelRows<float>;
}

/// Where the panel starts whose first row is `first`, a multiple of kPanelRows.  Row i of the triangle is row
/// i − first of its panel; entry (i, j) lies at panelStart + j · kPanelRows + i − first, zero where j > i.
template <class T>
constexpr long panelStart(int first)
{
    const long panel = first / kPanelRows<T>;
    return panel * (panel + 1) / 2 * kPanelRows<T> * kPanelRows<T>;
}

/// Fastest kernels this processor runs.
const CovarianceKernels& covarianceKernels();

/// Every variant this processor runs, fastest first (for tests and benchmarks).
/// count: how many; the array lives as long as the program.
const CovarianceKernels* const* availableCovarianceKernels(int& count);

}  // namespace terratact
