#include "core/learn/kernels/covariance_kernels.h"

#include "core/learn/kernels/kernel_targets.h"

// The part until HWY_ONCE is compiled once per instruction set. No templates of the standard
// library may be used there: instruction sets would share their symbols. Fused products are written
// out (MulAdd) and contraction is off: no compiler changes a bit.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/learn/kernels/covariance_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Offsets within a block are small, and loops over registers are unrolled by their counters.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result, modernize-loop-convert)
HWY_BEFORE_NAMESPACE();
namespace terratact::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::CappedTag<T, 64 / sizeof(T)>;
template <class T>
using Vector = hn::Vec<Tag<T>>;
using Doubles = Vector<double>;
template <class T>
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag<T>()));

constexpr bool kIsWide = kLanes<double> == 8;
/// Columns of L⁻¹k that the registers hold, times three vectors of rows.
constexpr int kColumns = kIsWide ? 8 : 4;
/// Columns of a panel to prefetch. The hardware's prefetch stops at every page; this helps where a
/// panel is read once or twice.
constexpr int kAhead = kIsWide ? 24 : 0;
constexpr int kVectors = 3;
constexpr int kSquareLanes = 16;  // partial sums per column, the same for every instruction set

template <class T>
HWY_INLINE Vector<T> load(const T* p)
{
    return hn::Load(Tag<T>(), p);
}

template <class T>
HWY_INLINE void store(T* p, Vector<T> v)
{
    hn::Store(v, Tag<T>(), p);
}

template <class T>
HWY_INLINE Vector<T> spread(T x)
{
    return hn::Set(Tag<T>(), x);
}

HWY_INLINE void storeRounded(double* p, Doubles v, double)
{
    store(p, v);
}

/// Stores values, with 0 for those below `least`.
HWY_INLINE void storeRounded(float* p, Doubles v, double least)
{
    const hn::Rebind<float, Tag<double>> half;
    hn::Store(hn::DemoteTo(half, hn::IfThenElseZero(hn::Gt(v, spread(least)), v)), half, p);
}

/// Computes e^x for x ≤ 0, with x = n ln 2 + r and |r| ≤ ½ ln 2. A polynomial of degree 11 in r
/// gives e^r. It is the minimax polynomial of the relative error by Remez's algorithm: 3e-18, or
/// 2e-17 with its first two coefficients rounded to 1.
/// Below −300 the result is e^−300. With a signal sd above 2e-12 even a covariance's square is then
/// a normal number. Processors need many times as long for subnormal ones.
/// Several vectors are computed together, because each step waits for the one before it.
template <int kRows>
HWY_INLINE void expNegative(Doubles (&x)[kRows])
{
    const Tag<double> d;
    const hn::RebindToSigned<Tag<double>> bits;
    const Doubles lowest = spread(-300.0);
    const Doubles shifter =
        spread(6755399441055744.0);  // 1.5 · 2^52: rounds to an integer in the low bits
    Doubles shifted[kRows], r[kRows], p[kRows];
#pragma GCC unroll 4
    for (int v = 0; v < kRows; ++v) {
        x[v] = hn::IfThenElse(hn::Gt(x[v], lowest), x[v], lowest);
        shifted[v] = hn::MulAdd(x[v], spread(1.4426950408889634), shifter);
        const Doubles n = hn::Sub(shifted[v], shifter);
        r[v] = hn::MulAdd(n, spread(-1.90821492927058770002e-10),
                          hn::MulAdd(n, spread(-6.93147180369123816490e-01), x[v]));
        p[v] = spread(2.49942933457304636056e-08);
    }
    const double coefficients[] = {2.763230822445254443505e-07,
                                   2.755762265202448847725e-06,
                                   2.480148648128348e-05,
                                   1.98412694324344382813e-04,
                                   1.388888895126120424963e-03,
                                   8.333333333559451797287e-03,
                                   4.16666666664926289885e-02,
                                   1.666666666666616816738e-01,
                                   5.000000000000017703211e-01,
                                   1.0,
                                   1.0};
#pragma GCC unroll 11
    for (const double c : coefficients)
#pragma GCC unroll 4
        for (int v = 0; v < kRows; ++v) p[v] = hn::MulAdd(p[v], r[v], spread(c));
#pragma GCC unroll 4
    for (int v = 0; v < kRows; ++v)
        x[v] = hn::BitCast(
            d, hn::Add(hn::BitCast(bits, p[v]), hn::ShiftLeft<52>(hn::BitCast(bits, shifted[v]))));
}

/// Computes the covariances of kRows training rows with one vector of columns.
template <int kRows, bool kKept, class T>
HWY_INLINE void covarianceRows(const CovarianceInput& in, const double* Z, int u, T* K,
                               Doubles& mean)
{
    Doubles distance2[kRows];
    for (int r = 0; r < kRows; ++r) distance2[r] = hn::Zero(Tag<double>());
    const double* x = in.X + static_cast<long>(u) * in.m;
    for (int j = 0; j < in.m; ++j) {
        const Doubles z = load(Z + static_cast<long>(j) * kGroup);
        const Doubles perLength = spread(in.perLength[j]);
#pragma GCC unroll 4
        for (int r = 0; r < kRows; ++r) {
            const Doubles d = hn::Mul(hn::Sub(z, spread(x[r * in.m + j])), perLength);
            distance2[r] = hn::MulAdd(d, d, distance2[r]);
        }
    }
#pragma GCC unroll 4
    for (int r = 0; r < kRows; ++r)
        distance2[r] = hn::MulAdd(spread(-0.5), distance2[r], spread(in.logWeight[u + r]));
    expNegative(distance2);
#pragma GCC unroll 4
    for (int r = 0; r < kRows; ++r) {
        const Doubles k = hn::Mul(spread(in.signal2), distance2[r]);
        if constexpr (kKept)
            storeRounded(K + static_cast<long>(u + r) * kGroup, k,
                         in.signal2 * kMinSingleCovariance);
        mean = hn::MulAdd(k, spread(in.alpha[u + r]), mean);
    }
}

template <class T>
void covariances(const CovarianceInput& in, const double* Z, T* K, double* mean)
{
    for (int c = 0; c < kGroup; c += kLanes<double>) {
        Doubles sum = hn::Zero(Tag<double>());
        int u = 0;
        for (; u + 4 <= in.kept; u += 4) covarianceRows<4, true>(in, Z + c, u, K + c, sum);
        for (; u < in.kept; ++u) covarianceRows<1, true>(in, Z + c, u, K + c, sum);
        for (; u + 4 <= in.U; u += 4) covarianceRows<4, false>(in, Z + c, u, K + c, sum);
        for (; u < in.U; ++u) covarianceRows<1, false>(in, Z + c, u, K + c, sum);
        store(mean + c, sum);
    }
}

/// Prefetches the three cache lines of one column of a panel.
[[maybe_unused]] inline void prefetch(const void* column)
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
HWY_INLINE void multiply(const T* panel, const T* K, int from, int to, Fetch fetch,
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
            const Vector<T> k = spread<T>(K[static_cast<long>(j) * kGroup + c]);
#pragma GCC unroll 3
            for (int v = kFrom; v < kTo; ++v) product[v][c] = hn::MulAdd(t[v], k, product[v][c]);
        }
    }
}

/// Multiplies three vectors of rows of a panel by kColumns columns; kUsed of them hold rows of the
/// triangle. Only sums of squares leave the registers. first: first row of the first vector; row:
/// the same within the panel.
template <class T, int kUsed>
HWY_INLINE void block(const T* panel, const T* K, int first, int row, Fetch fetch, T* squares)
{
    constexpr int L = kLanes<T>;
    Vector<T> product[kVectors][kColumns];
#pragma GCC unroll 3
    for (int v = 0; v < kVectors; ++v)
#pragma GCC unroll 8
        for (int c = 0; c < kColumns; ++c) product[v][c] = hn::Zero(Tag<T>());
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
            store(sum, hn::MulAdd(product[v][c], product[v][c], load(sum)));
        }
}

template <class T>
HWY_NOINLINE void fullBlock(const T* panel, const T* K, int first, int row, Fetch fetch, T* squares)
{
    block<T, 3>(panel, K, first, row, fetch, squares);
}

/// Computes a block in which U ends.
template <class T>
HWY_NOINLINE void lastBlock(const T* panel, const T* K, int first, int row, int used, Fetch fetch,
                            T* squares)
{
    if (used == 2)
        block<T, 2>(panel, K, first, row, fetch, squares);
    else
        block<T, 1>(panel, K, first, row, fetch, squares);
}

/// Number of times that a group passes through a panel.
template <class T>
constexpr int kPasses = kPanelRows<T> / (kVectors * kLanes<T>)*(kGroup / kColumns);

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
    return {next, ((columns + kPanelRows<T>)*kColumnBytes + passes * first - 1) / (passes * first)};
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
    for (int first = 0; first < U;
         first += kPanelRows<T>) {  // a panel stays in the cache for all groups
        const T* panel = panels + panelStart<T>(first);
        Fetch fetch = nextPanel(panel, first, U, groups);
        for (int g = 0; g < groups; ++g) {
            meter.add(static_cast<long>(first + kPanelRows<T>) * kPanelRows<T> * kGroup);
            multiplyPanel(panel, K + g * block, first, U, fetch,
                          squares + g * kGroup * kSquareLanes);
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

extern const CovarianceKernels kCovarianceKernels;
const CovarianceKernels kCovarianceKernels{nameOfTarget(HWY_TARGET), covariances<double>,
                                           covariances<float>, sumsOfSquares<double>,
                                           sumsOfSquares<float>};

}  // namespace terratact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result, modernize-loop-convert)

#if HWY_ONCE
namespace terratact {
namespace {

const KernelVariants<CovarianceKernels>& variants()
{
    static const KernelVariants<CovarianceKernels> found TERRATACT_KERNEL_VARIANTS(
        kCovarianceKernels);
    return found;
}

}  // namespace

const CovarianceKernels& covarianceKernels()
{
    return variants().fastest();
}

const CovarianceKernels* const* availableCovarianceKernels(int& count)
{
    count = variants().count();
    return variants().all();
}

}  // namespace terratact
#endif
