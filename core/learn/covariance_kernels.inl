// Compiled once per instruction set with TERRATACT_KERNEL_NAMESPACE, _NAME, _LANES, _ROWS and _VECTORS
// set: doubles per vector, and the block of products that the registers hold.
// No templates of the standard library in here: their symbols would be shared between instruction sets.

#include "core/learn/covariance_kernels.h"

namespace terratact::TERRATACT_KERNEL_NAMESPACE {

namespace {

constexpr int kLanes = TERRATACT_KERNEL_LANES;
typedef double Vec __attribute__((vector_size(8 * kLanes)));
typedef long long Bits __attribute__((vector_size(8 * kLanes)));

inline Vec load(const double* p)
{
    return *reinterpret_cast<const Vec*>(p);
}

inline void store(double* p, Vec v)
{
    *reinterpret_cast<Vec*>(p) = v;
}

inline Vec spread(double x)
{
    return x - Vec{};
}

/// e^x for x ≤ 0 by x = n ln 2 + r, Taylor to degree 13 on |r| ≤ ½ ln 2; below −708 it is e^−708.
inline Vec expNegative(Vec x)
{
    const Vec lowest = spread(-708.0);
    const Bits keep = x > lowest;
    x = (Vec)(((Bits)x & keep) | ((Bits)lowest & ~keep));
    const Vec shifter = spread(6755399441055744.0);  // 1.5 · 2^52: rounds to an integer in the low bits
    const Vec shifted = x * spread(1.4426950408889634) + shifter;
    const Vec n = shifted - shifter;
    const Vec r = (x - n * spread(6.93147180369123816490e-01)) - n * spread(1.90821492927058770002e-10);
    Vec p = spread(1.0 / 6227020800.0);
    const double inverseFactorials[] = {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0,
                                        1.0 / 40320.0,     1.0 / 5040.0,     1.0 / 720.0,     1.0 / 120.0,
                                        1.0 / 24.0,        1.0 / 6.0,        0.5,             1.0,
                                        1.0};
    for (const double c : inverseFactorials) p = p * r + spread(c);
    return (Vec)((Bits)p + ((Bits)shifted << 52));
}

void covariances(const double* X, const double* logWeight, const double* Z, int U, int m, int C, double signal2,
                 double* K)
{
    for (int c = 0; c < C; c += kLanes) {
        for (int u = 0; u < U; ++u) {
            Vec distance2 = spread(0.0);
            const double* x = X + static_cast<long>(u) * m;
            for (int j = 0; j < m; ++j) {
                const Vec d = spread(x[j]) - load(Z + static_cast<long>(j) * C + c);
                distance2 += d * d;
            }
            const Vec exponent = spread(logWeight[u]) - spread(0.5) * distance2;
            store(K + static_cast<long>(u) * C + c, spread(signal2) * expNegative(exponent));
        }
    }
}

/// kRows rows of one panel times kVectors · 8 columns; only the squares' sum leaves the registers.
template <int kRows, int kVectors>
inline void panelBlock(const double* panel, const double* K, int length, int C, double* out)
{
    Vec product[kRows][kVectors];
    for (int r = 0; r < kRows; ++r)
        for (int v = 0; v < kVectors; ++v) product[r][v] = spread(0.0);
    for (int j = 0; j < length; ++j) {
        Vec k[kVectors];
        for (int v = 0; v < kVectors; ++v) k[v] = load(K + static_cast<long>(j) * C + v * kLanes);
        for (int r = 0; r < kRows; ++r)
            for (int v = 0; v < kVectors; ++v) product[r][v] += spread(panel[j * kPanelRows + r]) * k[v];
    }
    for (int v = 0; v < kVectors; ++v) {
        Vec sum = load(out + v * kLanes);
        for (int r = 0; r < kRows; ++r) sum += product[r][v] * product[r][v];
        store(out + v * kLanes, sum);
    }
}

void sumsOfSquares(const double* panels, const double* K, int U, int C, double* out)
{
    constexpr int kRows = TERRATACT_KERNEL_ROWS;
    constexpr int kVectors = TERRATACT_KERNEL_VECTORS;
    for (int c = 0; c < C; c += kLanes) store(out + c, spread(0.0));
    const double* panel = panels;
    for (int first = 0; first < U; first += kPanelRows) {  // a panel stays in the cache for all columns
        const int length = first + kPanelRows;
        for (int r = 0; r < kPanelRows; r += kRows) {
            int c = 0;
            for (; c + kVectors * kLanes <= C; c += kVectors * kLanes)
                panelBlock<kRows, kVectors>(panel + r, K + c, length, C, out + c);
            for (; c < C; c += kLanes) panelBlock<kRows, 1>(panel + r, K + c, length, C, out + c);
        }
        panel += static_cast<long>(kPanelRows) * length;
    }
}

}  // namespace

extern const CovarianceKernels kKernels;
const CovarianceKernels kKernels{TERRATACT_KERNEL_NAME, covariances, sumsOfSquares};

}  // namespace terratact::TERRATACT_KERNEL_NAMESPACE
