#include "core/learn/kernels/likelihood_kernels.h"

#include "core/learn/kernels/kernel_targets.h"

// The part until HWY_ONCE is compiled once per instruction set. No templates of the standard
// library may be used there: instruction sets would share their symbols.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/learn/kernels/likelihood_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Compilers keep arrays of vectors in registers only if they unroll the loops over them early.
#undef TERRATACT_UNROLL
#ifdef __clang__
#define TERRATACT_UNROLL _Pragma("unroll")
#else
#define TERRATACT_UNROLL _Pragma("GCC unroll 8")
#endif

// Offsets within a block are small, and loops over registers are unrolled by their counters.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result, modernize-loop-convert)
HWY_BEFORE_NAMESPACE();
namespace terratact::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, kGroup>;
using Vec = hn::Vec<Tag>;

constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag()));
/// Block of products that the registers hold.
constexpr int kRows = kLanes == 8 ? 8 : 4;
constexpr int kVectors = kLanes == 8 ? 3 : 2;

HWY_INLINE Vec load(const double* p)
{
    return hn::Load(Tag(), p);
}

HWY_INLINE void store(double* p, Vec v)
{
    hn::Store(v, Tag(), p);
}

HWY_INLINE Vec spread(double x)
{
    return hn::Set(Tag(), x);
}

/// Returns the offset of column c of a tile in three groups with this stride.
constexpr long column(int c, long groupStride)
{
    return c / kGroup * groupStride + c % kGroup;
}

/// Computes kRows rows times kVectors vectors of columns, from column c on.
HWY_INLINE void block(const double* A, const double* B, long stride, int length, double* C,
                      long rowStride, long groupStride, int c)
{
    Vec product[kRows][kVectors];
    TERRATACT_UNROLL
    for (int r = 0; r < kRows; ++r) TERRATACT_UNROLL
    for (int v = 0; v < kVectors; ++v) product[r][v] = spread(0.0);
    const double* b[kVectors];
    TERRATACT_UNROLL
    for (int v = 0; v < kVectors; ++v) b[v] = B + column(c + v * kLanes, stride);
    for (long k = 0; k < length; ++k) {
        Vec columns[kVectors];
        TERRATACT_UNROLL
        for (int v = 0; v < kVectors; ++v) columns[v] = load(b[v] + k * kGroup);
        TERRATACT_UNROLL
        for (int r = 0; r < kRows; ++r) TERRATACT_UNROLL
        for (int v = 0; v < kVectors; ++v)
            product[r][v] = hn::MulAdd(spread(A[k * kGroup + r]), columns[v], product[r][v]);
    }
    TERRATACT_UNROLL
    for (int r = 0; r < kRows; ++r) TERRATACT_UNROLL
    for (int v = 0; v < kVectors; ++v) {
        double* to = C + r * rowStride + column(c + v * kLanes, groupStride);
        store(to, hn::Sub(load(to), product[r][v]));
    }
}

void subtractProducts(const double* A, const double* B, long stride, int length, double* C,
                      long rowStride, long groupStride)
{
    // C is read once per pass over the matrix: it is prefetched during the products
    for (int r = 0; r < kGroup; ++r)
        for (int c = 0; c < kTileColumns; c += kGroup)
            __builtin_prefetch(C + r * rowStride + column(c, groupStride), 1);
    for (int r = 0; r < kGroup; r += kRows)
        for (int c = 0; c < kTileColumns; c += kVectors * kLanes)
            block(A + r, B, stride, length, C + r * rowStride, rowStride, groupStride, c);
}

/// Computes a block of kInputs inputs from d on: their sums stay in registers for the whole row.
template <int kInputs>
HWY_INLINE void addSquares(const double* G, int columns, const double* x, const double* Z,
                           long stride, double* sums)
{
    Vec sum[kInputs];
    for (int d = 0; d < kInputs; ++d) sum[d] = load(sums + d * 8);
    for (int c = 0; c < columns; c += kLanes) {
        const Vec g = load(G + c);
        TERRATACT_UNROLL
        for (int d = 0; d < kInputs; ++d) {
            const Vec difference = hn::Sub(spread(x[d]), load(Z + d * stride + c));
            sum[d] = hn::MulAdd(hn::Mul(g, difference), difference, sum[d]);
        }
    }
    for (int d = 0; d < kInputs; ++d) store(sums + d * 8, sum[d]);
}

void addWeightedSquares(const double* N, const double* S, double alphaOfRow, const double* alpha,
                        int columns, const double* x, const double* Z, long stride, int m,
                        double* sums)
{
    constexpr int kMaxColumns = 512;
    constexpr int kInputs = 4;
    alignas(64) double G[kMaxColumns];
    for (int first = 0; first < columns; first += kMaxColumns) {
        const int count = columns - first < kMaxColumns ? columns - first : kMaxColumns;
        Vec total = load(sums + m * 8);
        for (int c = 0; c < count; c += kLanes) {
            const Vec minusG =
                hn::MulAdd(spread(alphaOfRow), load(alpha + first + c), load(N + first + c));
            const Vec g = hn::Mul(hn::Neg(minusG), load(S + first + c));
            store(G + c, g);
            total = hn::Add(total, g);
        }
        store(sums + m * 8, total);
        int d = 0;
        for (; d + kInputs <= m; d += kInputs)
            addSquares<kInputs>(G, count, x + d, Z + d * stride + first, stride, sums + d * 8);
        for (; d < m; ++d)
            addSquares<1>(G, count, x + d, Z + d * stride + first, stride, sums + d * 8);
    }
}

}  // namespace

extern const LikelihoodKernels kLikelihoodKernels;
const LikelihoodKernels kLikelihoodKernels{nameOfTarget(HWY_TARGET), subtractProducts,
                                           addWeightedSquares};

}  // namespace terratact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result, modernize-loop-convert)

#if HWY_ONCE
namespace terratact {
namespace {

const KernelVariants<LikelihoodKernels>& variants()
{
    static const KernelVariants<LikelihoodKernels> found TERRATACT_KERNEL_VARIANTS(
        kLikelihoodKernels);
    return found;
}

}  // namespace

const LikelihoodKernels& likelihoodKernels()
{
    return variants().fastest();
}

const LikelihoodKernels* const* availableLikelihoodKernels(int& count)
{
    count = variants().count();
    return variants().all();
}

}  // namespace terratact
#endif
