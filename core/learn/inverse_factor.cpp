#include "core/learn/inverse_factor.h"

#include <cblas.h>
#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/learn/covariance_kernels.h"

namespace terratact {

namespace {

constexpr int kProbes = 2 * kGroup;  // columns that singleError looks at

/// R⁻¹ in place, upper triangle.
void invert(Eigen::MatrixXd& R)
{
    const auto n = static_cast<lapack_int>(R.rows());
    LAPACKE_dtrtri(LAPACK_COL_MAJOR, 'U', 'N', n, R.data(), n);
}

/// Rows of the lower triangle L⁻¹ = (R⁻¹)ᵀ in panels.
template <class T>
AlignedArray<T> pack(const Eigen::MatrixXd& inverseR)
{
    constexpr int kRows = kPanelRows<T>;
    const auto U = static_cast<int>(inverseR.rows());
    AlignedArray<T> panels(static_cast<std::size_t>(panelStart<T>(paddedRows(U))));
    for (int i = 0; i < U; ++i) {
        const int first = i / kRows * kRows;
        T* out = panels.data() + panelStart<T>(first) + (i - first);
        const double* row = inverseR.data() + static_cast<Eigen::Index>(i) * U;
        for (int j = 0; j <= i; ++j) out[static_cast<long>(j) * kRows] = static_cast<T>(row[j]);
    }
    return panels;
}

Eigen::Index probe(int p, Eigen::Index U)
{
    return p * (U - 1) / (kProbes - 1);
}

/// K e_i = Rᵀ R e_i for the rows that singleError looks at: U × kProbes.
Eigen::MatrixXd probeColumns(const Eigen::MatrixXd& R)
{
    const Eigen::Index U = R.rows();
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(U, kProbes);
    for (int p = 0; p < kProbes; ++p) {
        const Eigen::Index i = probe(p, U);
        columns.col(p).head(i + 1) = R.col(i).head(i + 1);
    }
    const auto n = static_cast<int>(U);
    cblas_dtrmm(CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, n, kProbes, 1.0,
                R.data(), n, columns.data(), n);
    return columns;
}

double errorAt(const Eigen::MatrixXd& columns, const AlignedArray<float>& panels)
{
    const auto U = static_cast<int>(columns.rows());
    const long block = static_cast<long>(paddedRows(U)) * kGroup;
    AlignedArray<float> K(static_cast<std::size_t>(block) * kProbes / kGroup);
    AlignedArray<double> squares(kProbes);
    for (int p = 0; p < kProbes; ++p)
        for (int u = 0; u < U; ++u)
            K.data()[p / kGroup * block + u * kGroup + p % kGroup] =
                static_cast<float>(columns(u, p));
    covarianceKernels().sumsOfSquaresSingle(panels.data(), K.data(), U, kProbes / kGroup,
                                            squares.data());
    double error = 0.0;
    for (int p = 0; p < kProbes; ++p) {
        const double difference = std::abs(squares.data()[p] - columns(probe(p, U), p));
        if (!std::isfinite(difference)) return std::numeric_limits<double>::infinity();
        error = std::max(error, difference);
    }
    return error;
}

}  // namespace

InverseFactor::InverseFactor(Eigen::MatrixXd R, std::function<Eigen::MatrixXd()> again)
    : rows_(static_cast<int>(R.rows())), again_(std::move(again)), R_(std::move(R))
{
}

Eigen::MatrixXd InverseFactor::takeFactor() const
{
    if (!R_) return again_();
    Eigen::MatrixXd R = std::move(*R_);
    R_.reset();
    return R;
}

const double* InverseFactor::panels() const
{
    const std::scoped_lock lock(mutex_);
    if (!double_) {
        Eigen::MatrixXd R = takeFactor();
        invert(R);
        double_ = pack<double>(R);
    }
    return double_->data();
}

const InverseFactor::Single& InverseFactor::single() const
{
    const std::scoped_lock lock(mutex_);
    if (!single_) {
        Eigen::MatrixXd R = takeFactor();
        const Eigen::MatrixXd columns = probeColumns(R);
        invert(R);
        AlignedArray<float> panels = pack<float>(R);
        const double error = errorAt(columns, panels);
        single_ = Single{std::move(panels), error};
    }
    return *single_;
}

const float* InverseFactor::panelsSingle() const
{
    return single().panels.data();
}

double InverseFactor::singleError() const
{
    return single().error;
}

}  // namespace terratact
