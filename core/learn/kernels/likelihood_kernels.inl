// Compiled once per instruction set. The macros TERRATACT_KERNEL_NAMESPACE, _NAME, _LANES, _ROWS
// and _VECTORS must be set: doubles per vector, and the block of products that the registers hold.
// No templates of the standard library may be used here: instruction sets would share their
// symbols.

#include "core/learn/kernels/likelihood_kernels.h"

// Compilers keep arrays of vectors in registers only if they unroll the loops over them early.
#ifdef __clang__
#define TERRATACT_UNROLL _Pragma("unroll")
#else
#define TERRATACT_UNROLL _Pragma("GCC unroll 8")
#endif

namespace terratact::TERRATACT_KERNEL_NAMESPACE {

namespace {

constexpr int kLanes = TERRATACT_KERNEL_LANES;
constexpr int kRows = TERRATACT_KERNEL_ROWS;
constexpr int kVectors = TERRATACT_KERNEL_VECTORS;
typedef double Vec __attribute__((vector_size(8 * kLanes)));

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

/// Returns the offset of column c of a tile in three groups with this stride.
inline long column(int c, long groupStride)
{
    return c / kGroup * groupStride + c % kGroup;
}

/// Computes kRows rows times kVectors vectors of columns, from column c on.
inline void block(const double* A, const double* B, long stride, int length, double* C, long rowStride,
                  long groupStride, int c)
{
    Vec product[kRows][kVectors];
    TERRATACT_UNROLL
    for (int r = 0; r < kRows; ++r)
        TERRATACT_UNROLL
        for (int v = 0; v < kVectors; ++v) product[r][v] = spread(0.0);
    const double* b[kVectors];
    TERRATACT_UNROLL
    for (int v = 0; v < kVectors; ++v) b[v] = B + column(c + v * kLanes, stride);
    for (long k = 0; k < length; ++k) {
        Vec columns[kVectors];
        TERRATACT_UNROLL
        for (int v = 0; v < kVectors; ++v) columns[v] = load(b[v] + k * kGroup);
        TERRATACT_UNROLL
        for (int r = 0; r < kRows; ++r)
            TERRATACT_UNROLL
            for (int v = 0; v < kVectors; ++v) product[r][v] += spread(A[k * kGroup + r]) * columns[v];
    }
    TERRATACT_UNROLL
    for (int r = 0; r < kRows; ++r)
        TERRATACT_UNROLL
        for (int v = 0; v < kVectors; ++v) {
            double* to = C + r * rowStride + column(c + v * kLanes, groupStride);
            store(to, load(to) - product[r][v]);
        }
}

void subtractProducts(const double* A, const double* B, long stride, int length, double* C, long rowStride,
                      long groupStride)
{
    // C is read once per pass over the matrix: it is prefetched during the products
    for (int r = 0; r < kGroup; ++r)
        for (int c = 0; c < kTileColumns; c += kGroup) __builtin_prefetch(C + r * rowStride + column(c, groupStride), 1);
    for (int r = 0; r < kGroup; r += kRows)
        for (int c = 0; c < kTileColumns; c += kVectors * kLanes)
            block(A + r, B, stride, length, C + r * rowStride, rowStride, groupStride, c);
}

/// Computes a block of kInputs inputs from d on: their sums stay in registers for the whole row.
template <int kInputs>
inline void addSquares(const double* G, int columns, const double* x, const double* Z, long stride, double* sums)
{
    Vec sum[kInputs];
    for (int d = 0; d < kInputs; ++d) sum[d] = load(sums + d * 8);
    for (int c = 0; c < columns; c += kLanes) {
        const Vec g = load(G + c);
        TERRATACT_UNROLL
        for (int d = 0; d < kInputs; ++d) {
            const Vec difference = spread(x[d]) - load(Z + d * stride + c);
            sum[d] += g * difference * difference;
        }
    }
    for (int d = 0; d < kInputs; ++d) store(sums + d * 8, sum[d]);
}

void addWeightedSquares(const double* N, const double* S, double alphaOfRow, const double* alpha, int columns,
                        const double* x, const double* Z, long stride, int m, double* sums)
{
    constexpr int kMaxColumns = 512;
    constexpr int kInputs = 4;
    alignas(64) double G[kMaxColumns];
    for (int first = 0; first < columns; first += kMaxColumns) {
        const int count = columns - first < kMaxColumns ? columns - first : kMaxColumns;
        Vec total = load(sums + m * 8);
        for (int c = 0; c < count; c += kLanes) {
            const Vec g = (-load(N + first + c) - spread(alphaOfRow) * load(alpha + first + c)) * load(S + first + c);
            store(G + c, g);
            total += g;
        }
        store(sums + m * 8, total);
        int d = 0;
        for (; d + kInputs <= m; d += kInputs)
            addSquares<kInputs>(G, count, x + d, Z + d * stride + first, stride, sums + d * 8);
        for (; d < m; ++d) addSquares<1>(G, count, x + d, Z + d * stride + first, stride, sums + d * 8);
    }
}

}  // namespace

extern const LikelihoodKernels kKernels;
const LikelihoodKernels kKernels{TERRATACT_KERNEL_NAME, subtractProducts, addWeightedSquares};

}  // namespace terratact::TERRATACT_KERNEL_NAMESPACE
