#pragma once

namespace terratact {

/// Number of columns (chains) that a prediction computes at a time.
inline constexpr int kGroup = 8;

/// Returns the number of groups that hold this many columns.
constexpr int groupsOf(int columns)
{
    return (columns + kGroup - 1) / kGroup;
}

/// Rows of L⁻¹ in one panel: 192 bytes.
template <class T>
inline constexpr int kPanelRows = 192 / static_cast<int>(sizeof(T));

/// Covariances below this share of signal² are 0 in single precision, because they could become
/// subnormal.
inline constexpr double kMinSingleCovariance = 1e-30;

/// Input of the covariances with the training rows, for 8 columns of moving inputs.
struct CovarianceInput {
    const double* X = nullptr;          ///< U × m, row-major
    const double* perLength = nullptr;  ///< m: 1 / ℓ
    const double* logWeight = nullptr;  ///< U
    const double* alpha = nullptr;      ///< U
    int U = 0;
    int kept = 0;  ///< at most U: the covariances of the first rows are written
    int m = 0;
    double signal2 = 1.0;
};

/// Poll that a kernel calls every few milliseconds; it may throw. It is no std::function, whose
/// code would be shared between instruction sets.
struct KernelPoll {
    void (*call)(const void* context) = nullptr;
    const void* context = nullptr;
};

/// Approximate number of a kernel's multiplications between two polls.
inline constexpr long kKernelMultiplications = 1L << 25;

/// Hot loops of prediction, compiled for several instruction sets from one source by Highway. All
/// pointers must be 64-byte aligned. A column's result does not depend on its neighbours. AVX-512
/// and AVX2 give the same bits, because both use fused products in the same order.
struct CovarianceKernels {
    const char* name;  ///< of the instruction set, see nameOfTarget()

    /// Computes a block of covariances and the mean, for c < 8:
    ///   K[u·8 + c] = signal² exp(logWeight[u] − ½ Σ_j ((X[u·m + j] − Z[j·8 + c]) perLength[j])²),  u < kept
    ///   mean[c] = Σ_u K[u·8 + c] alpha[u],  u < U
    /// The exponent is at least −300. Z: m × 8. Differences are scaled, not inputs: scaled inputs have
    /// rounding errors of 2⁻⁵³ |x| / ℓ, which is much if ℓ is tiny.
    void (*covariances)(const CovarianceInput& in, const double* Z, double* K, double* mean);
    /// Computes the same with K rounded to float; the mean is summed before the rounding.
    void (*covariancesSingle)(const CovarianceInput& in, const double* Z, float* K, double* mean);

    /// Computes out[g·8 + c] = Σ_{i < U} (Σ_{j ≤ i} T[i][j] K_g[j·8 + c])², c < 8, for `groups`
    /// consecutive blocks K_g. Each block is paddedRows(U) × 8 and zero from row U on. T is a lower
    /// triangle in panels.
    void (*sumsOfSquares)(const double* panels, const double* K, int U, int groups, double* out,
                          KernelPoll poll);
    /// Computes the same with products and squares in float; the last sum over 16 values is double.
    void (*sumsOfSquaresSingle)(const float* panels, const float* K, int U, int groups, double* out,
                                KernelPoll poll);
};

/// Returns the rows of a block of covariances: U, rounded up to full panels of either precision.
constexpr int paddedRows(int U)
{
    return (U + kPanelRows<float> - 1) / kPanelRows<float> * kPanelRows<float>;
}

/// Returns the start of the panel whose first row is `first`, a multiple of kPanelRows. Row i of
/// the triangle is row i − first of its panel. Entry (i, j) lies at panelStart + j · kPanelRows + i
/// − first, and is zero for j > i.
template <class T>
constexpr long panelStart(int first)
{
    const long panel = first / kPanelRows<T>;
    return panel * (panel + 1) / 2 * kPanelRows<T> * kPanelRows<T>;
}

/// Returns the fastest kernels that this processor runs.
const CovarianceKernels& covarianceKernels();

/// Returns every variant that this processor runs, fastest first, for tests and benchmarks. count:
/// their number. The array lives as long as the program.
const CovarianceKernels* const* availableCovarianceKernels(int& count);

}  // namespace terratact
