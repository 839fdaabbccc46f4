#include "core/learn/kernels/symmetric_panels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/learn/kernels/blas.h"
#include "core/learn/kernels/likelihood_kernels.h"

namespace terratact {

namespace {

constexpr int kPanel = SymmetricPanels::kPanelColumns;
constexpr long kStride = long{kPanel} * kGroup;  // stride of a packed group
constexpr int kCachedRows = 512;    // the packed groups of so many rows stay in a core's own cache
constexpr long kUnitsOfTile = 512;  // units of PolledWork: some microseconds

int roundUp(int n, int multiple)
{
    return (n + multiple - 1) / multiple * multiple;
}

std::size_t count(long n)
{
    return static_cast<std::size_t>(n);
}

/// Returns room for the groups of n rows and the excess of the last tile.
AlignedArray<double> packedRows(int n, const Poll& poll = {})
{
    return {count((roundUp(n, kTileColumns) / kGroup) * kStride), poll};
}

/// L⁻¹ of the pivot block, packed by rows and by columns.
struct PivotInverse {
    AlignedArray<double> rows = packedRows(kPanel);
    AlignedArray<double> columns = packedRows(kPanel);
};

void pack(const Eigen::MatrixXd& inverseL, PivotInverse& pivot)
{
    pivot.rows.setZero();
    pivot.columns.setZero();
    for (long i = 0; i < inverseL.rows(); ++i)
        for (long k = 0; k <= i; ++k) {
            pivot.rows.data()[i / kGroup * kStride + k * kGroup + i % kGroup] = inverseL(i, k);
            pivot.columns.data()[k / kGroup * kStride + i * kGroup + k % kGroup] = inverseL(i, k);
        }
}

/// Inversion of one matrix: the steps of SymmetricPanels::invert, pivot block by pivot block.
class Sweep {
public:
    Sweep(SymmetricPanels& A, Eigen::VectorXd& y, const Poll& poll)
        : A_(A), y_(y), work_(poll), n_(A.paddedSize()), V_(packedRows(n_, poll)),
          W_(packedRows(n_, poll))
    {
    }

    bool pivot(int panel, SymmetricPanels::Factors& factors)
    {
        panel_ = panel;
        first_ = panel * kPanel;
        width_ = std::min(kPanel, n_ - first_);
        if (!invertPivot(factors)) return false;
        packColumns();
        multiply();
        sweepOutput(factors);
        for (int from = 0; from < n_; from += kCachedRows)
            update(from, std::min(n_, from + kCachedRows));
        replaceColumns();
        return true;
    }

private:
    bool isPivot(int row) const { return row >= first_ && row < first_ + width_; }
    double* group(AlignedArray<double>& packed, int row) const
    {
        return packed.data() + row / kGroup * kStride;
    }

    /// Computes one tile of C −= A Bᵀ and polls.
    void subtract(const double* a, const double* b, int length, double* C, long rowStride,
                  long groupStride)
    {
        likelihoodKernels().subtractProducts(a, b, kStride, length, C, rowStride, groupStride);
        work_.done(kUnitsOfTile);
    }

    bool invertPivot(SymmetricPanels::Factors& factors)
    {
        Eigen::MatrixXd L = Eigen::MatrixXd::Zero(width_, width_);
        for (int i = 0; i < width_; ++i)
            for (int j = 0; j <= i; ++j) L(i, j) = A_.row(panel_, first_ + i)[j];
        if (blas(LAPACKE_dpotrf, LAPACK_COL_MAJOR, 'L', width_, L.data(), width_) != 0)
            return false;
        if (!L.diagonal().allFinite()) return false;
        const auto own = L.diagonal().head(std::min(width_, A_.size() - first_));
        factors.leastPivot = std::min(factors.leastPivot, own.minCoeff());
        factors.mostPivot = std::max(factors.mostPivot, own.maxCoeff());
        factors.logDeterminant += 2.0 * L.diagonal().array().log().sum();
        blas(LAPACKE_dtrtri, LAPACK_COL_MAJOR, 'L', 'N', width_, L.data(), width_);
        pack(L, inverse_);
        return true;
    }

    /// Packs V = A_·k; the pivot's own rows are neither written nor read.
    void packColumns()
    {
        for (int left = 0; left < panel_; ++left)
            for (int k = 0; k < width_; ++k) {
                const double* from = A_.row(left, first_ + k);
                double* to = group(V_, left * kPanel) + static_cast<long>(k) * kGroup;
                for (int i = 0; i < kPanel; i += kGroup, to += kStride)
                    std::copy_n(from + i, kGroup, to);
            }
        for (int i = first_ + width_; i < n_; i += kGroup) {
            const double* from = A_.row(panel_, i);
            double* to = group(V_, i);
            for (int k = 0; k < width_; ++k)
                for (int r = 0; r < kGroup; ++r) *to++ = from[r * kPanel + k];
        }
    }

    /// Computes W = −V L⁻ᵀ; the sign cancels wherever W is used.
    void multiply()
    {
        W_.setZero();
        for (int i = 0; i < n_; i += kTileColumns) {
            if (isPivot(i)) continue;
            for (int j = 0; j < width_; j += kGroup)
                subtract(group(inverse_.rows, j), group(V_, i), j + kGroup,
                         group(W_, i) + static_cast<long>(j) * kGroup, kGroup, kStride);
        }
    }

    /// Treats y as one more row of A.
    void sweepOutput(SymmetricPanels::Factors& factors)
    {
        Eigen::VectorXd w = Eigen::VectorXd::Zero(width_);
        for (int j = 0; j < width_; ++j)
            for (int k = 0; k <= j; ++k)
                w[j] -= y_[first_ + k] * group(inverse_.rows, j)[k * kGroup + j % kGroup];
        factors.quadratic += w.squaredNorm();
        for (int i = 0; i < n_; i += kGroup) {
            if (isPivot(i)) continue;
            const Eigen::Map<const Eigen::Matrix<double, kGroup, Eigen::Dynamic>> W(group(W_, i),
                                                                                    kGroup, width_);
            y_.segment<kGroup>(i).noalias() -= W * w;
        }
        for (int k = 0; k < width_; ++k) {
            double sum = 0.0;
            for (int j = k; j < width_; ++j)
                sum -= w[j] * group(inverse_.rows, j)[k * kGroup + j % kGroup];
            y_[first_ + k] = sum;
        }
    }

    /// Computes A_ij −= W_i W_jᵀ for rows from … to of the lower triangle.
    void update(int from, int to)
    {
        for (int j = 0; j < to; j += kTileColumns) {
            if (isPivot(j)) continue;
            const int panel = j / kPanel;
            for (int i = std::max(from, j); i < to; i += kGroup)
                if (!isPivot(i))
                    subtract(group(W_, i), group(W_, j), width_, A_.row(panel, i) + j % kPanel,
                             kPanel, kGroup);
        }
    }

    /// Computes A_·k = W L⁻¹ and A_kk = −L⁻ᵀ L⁻¹.
    void replaceColumns()
    {
        const auto tile = [&](const double* a, const double* b, int k, double* C) {
            for (int r = 0; r < kGroup; ++r) std::fill_n(C + long{r} * kPanel, kTileColumns, 0.0);
            const long skipped = static_cast<long>(k) * kGroup;  // zeros of the triangle
            subtract(a + skipped, b + skipped, width_ - k, C, kPanel, kGroup);
        };
        for (int k = 0; k < width_; k += kGroup)
            for (int j = 0; j < first_; j += kTileColumns)
                tile(group(inverse_.columns, k), group(W_, j), k,
                     A_.row(j / kPanel, first_ + k) + j % kPanel);
        for (int k = 0; k < width_; k += kTileColumns)
            for (int i = first_; i < n_; i += kGroup)
                tile(isPivot(i) ? group(inverse_.columns, i - first_) : group(W_, i),
                     group(inverse_.columns, k), k, A_.row(panel_, i) + k);
    }

    SymmetricPanels& A_;
    Eigen::VectorXd& y_;
    PolledWork work_;
    int n_;
    int panel_ = 0, first_ = 0, width_ = 0;
    AlignedArray<double> V_, W_;
    PivotInverse inverse_;
};

}  // namespace

SymmetricPanels::SymmetricPanels(int n, const Poll& poll)
    : n_(n), padded_(roundUp(n, kGroup)),
      values_(count(offset(panels(), panels() * kPanelColumns)), poll)
{
    for (int u = n_; u < padded_; ++u) row(u / kPanelColumns, u)[u % kPanelColumns] = 1.0;
}

long SymmetricPanels::offset(int panel, int u) const
{
    const long first = static_cast<long>(panel) * kPanelColumns;
    const long before = panel * static_cast<long>(padded_)
                      - kPanelColumns * (static_cast<long>(panel) * (panel - 1) / 2);
    return (before + u - first) * kPanelColumns;
}

double* SymmetricPanels::row(int panel, int u)
{
    return values_.data() + offset(panel, u);
}

const double* SymmetricPanels::row(int panel, int u) const
{
    return values_.data() + offset(panel, u);
}

bool SymmetricPanels::invert(Eigen::VectorXd& y, Factors& factors, const Poll& poll)
{
    factors = {};
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(padded_);
    solution.head(n_) = y;
    Sweep sweep(*this, solution, poll);
    for (int panel = 0; panel < panels(); ++panel)
        if (!sweep.pivot(panel, factors)) return false;
    y = solution.head(n_);
    return true;
}

}  // namespace terratact
