// Compiled once per instruction set. These macros must be set, all with the prefix
// TERRATACT_KERNEL:
//   _NAMESPACE, _NAME
//   _BYTES    of a vector
//   _COLUMNS  of L⁻¹k that the registers hold, times three vectors of rows
//   _AHEAD    columns of a panel to prefetch. The hardware's prefetch stops at every page; this helps
//             where a panel is read once or twice.
// No templates of the standard library may be used here: instruction sets would share their
// symbols. Fused products are written out (fma) and contraction is off: no compiler changes a bit.

#include "core/learn/kernels/covariance_kernels.h"

#if TERRATACT_KERNEL_BYTES > 16
#include <immintrin.h>
#endif

namespace terratact::TERRATACT_KERNEL_NAMESPACE {

namespace {

constexpr int kBytes = TERRATACT_KERNEL_BYTES;
constexpr int kColumns = TERRATACT_KERNEL_COLUMNS;
constexpr int kAhead = TERRATACT_KERNEL_AHEAD;
constexpr int kVectors = 3;
constexpr int kSquareLanes = 16;  // partial sums per column, the same for every instruction set

typedef double Doubles __attribute__((vector_size(kBytes)));
typedef float Floats __attribute__((vector_size(kBytes)));
typedef long long Bits __attribute__((vector_size(kBytes)));

template <class T>
struct VectorOf;
template <>
struct VectorOf<double> {
    using type = Doubles;
};
template <>
struct VectorOf<float> {
    using type = Floats;
};
template <class T>
using Vector = typename VectorOf<T>::type;
template <class T>
constexpr int kLanes = kBytes / static_cast<int>(sizeof(T));

#if TERRATACT_KERNEL_BYTES == 64
inline Doubles fma(Doubles a, Doubles b, Doubles c)
{
    return (Doubles)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
}
inline Floats fma(Floats a, Floats b, Floats c)
{
    return (Floats)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
}
#elif TERRATACT_KERNEL_BYTES == 32
inline Doubles fma(Doubles a, Doubles b, Doubles c)
{
    return (Doubles)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
}
inline Floats fma(Floats a, Floats b, Floats c)
{
    return (Floats)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
}
#else
template <class V>
inline V fma(V a, V b, V c)
{
    return a * b + c;
}
#endif

template <class T>
inline Vector<T> load(const T* p)
{
    return *reinterpret_cast<const Vector<T>*>(p);
}

template <class T>
inline void store(T* p, Vector<T> v)
{
    *reinterpret_cast<Vector<T>*>(p) = v;
}

template <class T>
inline Vector<T> spread(T x)
{
    return x - Vector<T>{};
}

inline void storeRounded(double* p, Doubles v, double)
{
    store<double>(p, v);
}

/// Stores values, with 0 for those below `least`.
inline void storeRounded(float* p, Doubles v, double least)
{
    const Bits keep = v > spread(least);
    v = (Doubles)((Bits)v & keep);
    typedef float Half __attribute__((vector_size(kBytes / 2)));
    *reinterpret_cast<Half*>(p) = __builtin_convertvector(v, Half);
}

/// Computes e^x for x ≤ 0 by x = n ln 2 + r, |r| ≤ ½ ln 2, with a polynomial of degree 11 in r. It
/// is the minimax polynomial of the relative error by Remez's algorithm: 3e-18, or 2e-17 with its
/// first two coefficients rounded to 1.
/// Below −300 the result is e^−300. With a signal sd above 2e-12 even a covariance's square is then
/// a normal number. Processors need many times as long for subnormal ones.
/// Several vectors are computed together, because each step waits for the one before it.
template <int kRows>
[[gnu::always_inline]] inline void expNegative(Doubles (&x)[kRows])
{
    const Doubles lowest = spread(-300.0);
    const Doubles shifter =
        spread(6755399441055744.0);  // 1.5 · 2^52: rounds to an integer in the low bits
    Doubles shifted[kRows], r[kRows], p[kRows];
#pragma GCC unroll 4
    for (int v = 0; v < kRows; ++v) {
        const Bits keep = x[v] > lowest;
        x[v] = (Doubles)(((Bits)x[v] & keep) | ((Bits)lowest & ~keep));
        shifted[v] = fma(x[v], spread(1.4426950408889634), shifter);
        const Doubles n = shifted[v] - shifter;
        r[v] = fma(n, spread(-1.90821492927058770002e-10),
                   fma(n, spread(-6.93147180369123816490e-01), x[v]));
        p[v] = spread(2.49942933457304636056e-08);
    }
    const double coefficients[] = {2.763230822445254443505e-07, 2.755762265202448847725e-06,
                                   2.480148648128348e-05,       1.98412694324344382813e-04,
                                   1.388888895126120424963e-03, 8.333333333559451797287e-03,
                                   4.16666666664926289885e-02,  1.666666666666616816738e-01,
                                   5.000000000000017703211e-01, 1.0,
                                   1.0};
#pragma GCC unroll 11
    for (const double c : coefficients)
#pragma GCC unroll 4
        for (int v = 0; v < kRows; ++v) p[v] = fma(p[v], r[v], spread(c));
#pragma GCC unroll 4
    for (int v = 0; v < kRows; ++v) x[v] = (Doubles)((Bits)p[v] + ((Bits)shifted[v] << 52));
}

/// Computes the covariances of kRows training rows with one vector of columns.
template <int kRows, bool kKept, class T>
inline void covarianceRows(const CovarianceInput& in, const double* Z, int u, T* K, Doubles& mean)
{
    Doubles distance2[kRows] = {};
    const double* x = in.X + static_cast<long>(u) * in.m;
    for (int j = 0; j < in.m; ++j) {
        const Doubles z = load(Z + static_cast<long>(j) * kGroup);
        const Doubles perLength = spread(in.perLength[j]);
#pragma GCC unroll 4
        for (int r = 0; r < kRows; ++r) {
            const Doubles d = (z - spread(x[r * in.m + j])) * perLength;
            distance2[r] = fma(d, d, distance2[r]);
        }
    }
#pragma GCC unroll 4
    for (int r = 0; r < kRows; ++r)
        distance2[r] = fma(spread(-0.5), distance2[r], spread(in.logWeight[u + r]));
    expNegative(distance2);
#pragma GCC unroll 4
    for (int r = 0; r < kRows; ++r) {
        const Doubles k = spread(in.signal2) * distance2[r];
        if constexpr (kKept)
            storeRounded(K + static_cast<long>(u + r) * kGroup, k, in.signal2 * kMinSingleCovariance);
        mean = fma(k, spread(in.alpha[u + r]), mean);
    }
}

template <class T>
void covariances(const CovarianceInput& in, const double* Z, T* K, double* mean)
{
    for (int c = 0; c < kGroup; c += kLanes<double>) {
        Doubles sum{};
        int u = 0;
        for (; u + 4 <= in.kept; u += 4) covarianceRows<4, true>(in, Z + c, u, K + c, sum);
        for (; u < in.kept; ++u) covarianceRows<1, true>(in, Z + c, u, K + c, sum);
        for (; u + 4 <= in.U; u += 4) covarianceRows<4, false>(in, Z + c, u, K + c, sum);
        for (; u < in.U; ++u) covarianceRows<1, false>(in, Z + c, u, K + c, sum);
        store(mean + c, sum);
    }
}

/// Prefetches the three cache lines of one column of a panel.
inline void prefetch(const void* column)
{
    for (int line = 0; line < 3; ++line)
        __builtin_prefetch(static_cast<const char*>(column) + 64 * line);
}

/// Prefetch into the second-level cache: this many bytes from here on with every column.
struct Fetch {
    const char* from;
    long perColumn;
};

/// Adds columns from … to − 1 of the triangle times K, for the vectors of rows kFrom … kTo − 1.
template <class T, int kFrom, int kTo>
[[gnu::always_inline]] inline void multiply(const T* panel, const T* K, int from, int to, Fetch fetch,
                                            Vector<T> (&product)[kVectors][kColumns])
{
    for (int j = from; j < to; ++j) {
        if constexpr (kAhead > 0) prefetch(panel + static_cast<long>(j + kAhead) * kPanelRows<T>);
        for (long byte = 0; byte < fetch.perColumn; byte += 64)
            __builtin_prefetch(fetch.from + j * fetch.perColumn + byte, 0, 2);
        Vector<T> t[kVectors];
#pragma GCC unroll 3
        for (int v = kFrom; v < kTo; ++v)
            t[v] = load(panel + static_cast<long>(j) * kPanelRows<T> + v * kLanes<T>);
#pragma GCC unroll 8
        for (int c = 0; c < kColumns; ++c) {
            const Vector<T> k = spread(K[static_cast<long>(j) * kGroup + c]);
#pragma GCC unroll 3
            for (int v = kFrom; v < kTo; ++v) product[v][c] = fma(t[v], k, product[v][c]);
        }
    }
}

/// Multiplies three vectors of rows of a panel by kColumns columns; kUsed of them hold rows of the
/// triangle. Only sums of squares leave the registers. first: first row of the first vector; row:
/// the same within the panel.
template <class T, int kUsed>
[[gnu::always_inline]] inline void block(const T* panel, const T* K, int first, int row, Fetch fetch,
                                         T* squares)
{
    constexpr int L = kLanes<T>;
    Vector<T> product[kVectors][kColumns];
#pragma GCC unroll 3
    for (int v = 0; v < kVectors; ++v)
#pragma GCC unroll 8
        for (int c = 0; c < kColumns; ++c) product[v][c] = Vector<T>{};
    multiply<T, 0, kUsed>(panel + row, K, 0, first + L, fetch, product);
    if constexpr (kUsed > 1)
        multiply<T, 1, kUsed>(panel + row, K, first + L, first + 2 * L, fetch, product);
    if constexpr (kUsed > 2)
        multiply<T, 2, kUsed>(panel + row, K, first + 2 * L, first + 3 * L, fetch, product);
#pragma GCC unroll 8
    for (int c = 0; c < kColumns; ++c)
#pragma GCC unroll 3
        for (int v = 0; v < kUsed; ++v) {
            T* sum = squares + c * kSquareLanes + (row + v * L) % kSquareLanes;
            store(sum, fma(product[v][c], product[v][c], load(sum)));
        }
}

template <class T>
[[gnu::noinline]] void fullBlock(const T* panel, const T* K, int first, int row, Fetch fetch, T* squares)
{
    block<T, 3>(panel, K, first, row, fetch, squares);
}

/// Computes a block in which U ends.
template <class T>
[[gnu::noinline]] void lastBlock(const T* panel, const T* K, int first, int row, int used, Fetch fetch,
                               T* squares)
{
    if (used == 2)
        block<T, 2>(panel, K, first, row, fetch, squares);
    else
        block<T, 1>(panel, K, first, row, fetch, squares);
}

/// Number of times that a group passes through a panel.
template <class T>
constexpr int kPasses = kPanelRows<T> / (kVectors * kLanes<T>) * (kGroup / kColumns);

/// Multiplies one panel by the eight columns of a group. squares: 8 × kSquareLanes, added to.
/// fetch: advanced.
template <class T>
inline void multiplyPanel(const T* panel, const T* K, int first, int U, Fetch& fetch, T* squares)
{
    constexpr int kRows = kVectors * kLanes<T>;
    for (int row = 0; row < kPanelRows<T> && first + row < U; row += kRows) {
        const int used = (U - first - row + kLanes<T> - 1) / kLanes<T>;
        for (int c = 0; c < kGroup; c += kColumns) {
            if (used >= kVectors)
                fullBlock(panel, K + c, first + row, row, fetch, squares + c * kSquareLanes);
            else
                lastBlock(panel, K + c, first + row, row, used, fetch, squares + c * kSquareLanes);
            fetch.from += (first + row) * fetch.perColumn;
        }
    }
}

/// Returns the prefetch of the next panel, in equal parts with the columns of every pass. There is
/// none behind the last panel. With one pass there is none either, because that pass is as slow as
/// the memory.
template <class T>
inline Fetch nextPanel(const T* panel, int first, int U, int groups)
{
    constexpr long kColumnBytes = kPanelRows<T> * static_cast<long>(sizeof(T));
    const long columns = first + kPanelRows<T>;
    const long passes = static_cast<long>(groups) * kPasses<T>;
    if (columns >= U || first == 0 || passes == 1) return {nullptr, 0};
    const auto* next = reinterpret_cast<const char*>(panel) + columns * kColumnBytes;
    return {next, ((columns + kPanelRows<T>) * kColumnBytes + passes * first - 1) / (passes * first)};
}

constexpr int kMaxGroups = 8;  // their partial sums are on the stack

/// Counts multiplications and polls.
struct Meter {
    KernelPoll poll;
    long done = 0;

    void add(long multiplications)
    {
        done += multiplications;
        if (done < kKernelMultiplications) return;
        done = 0;
        if (poll.call) poll.call(poll.context);
    }
};

template <class T>
void sumsOfSquaresOf(const T* panels, const T* K, int U, int groups, double* out, Meter& meter)
{
    alignas(64) T squares[kMaxGroups * kGroup * kSquareLanes] = {};
    const long block = static_cast<long>(paddedRows(U)) * kGroup;
    for (int first = 0; first < U; first += kPanelRows<T>) {  // a panel stays in the cache for all groups
        const T* panel = panels + panelStart<T>(first);
        Fetch fetch = nextPanel(panel, first, U, groups);
        for (int g = 0; g < groups; ++g) {
            meter.add(static_cast<long>(first + kPanelRows<T>) * kPanelRows<T> * kGroup);
            multiplyPanel(panel, K + g * block, first, U, fetch, squares + g * kGroup * kSquareLanes);
        }
    }
    for (int c = 0; c < groups * kGroup; ++c) {
        out[c] = 0.0;
        for (int lane = 0; lane < kSquareLanes; ++lane)
            out[c] += static_cast<double>(squares[c * kSquareLanes + lane]);
    }
}

template <class T>
void sumsOfSquares(const T* panels, const T* K, int U, int groups, double* out, KernelPoll poll)
{
    Meter meter{poll};
    const long block = static_cast<long>(paddedRows(U)) * kGroup;
    for (int g = 0; g < groups; g += kMaxGroups)
        sumsOfSquaresOf(panels, K + g * block, U, groups - g < kMaxGroups ? groups - g : kMaxGroups,
                        out + g * kGroup, meter);
}

}  // namespace

extern const CovarianceKernels kKernels;
const CovarianceKernels kKernels{TERRATACT_KERNEL_NAME, covariances<double>, covariances<float>,
                                 sumsOfSquares<double>, sumsOfSquares<float>};

}  // namespace terratact::TERRATACT_KERNEL_NAMESPACE
