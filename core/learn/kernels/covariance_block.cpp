#include "core/learn/kernels/covariance_block.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/learn/kernels/blas_size.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

ScaledRows inLengthScales(Eigen::MatrixXd X, const Hyperparameters& hyper)
{
    ScaledRows rows{std::move(X), hyper.lengthScale.cwiseInverse().transpose()};
    for (Eigen::Index d = 0; d < rows.X.cols(); ++d)
        if (!std::isfinite(rows.perLength[d]) || !(rows.X.col(d) * rows.perLength[d]).allFinite())
            throw std::invalid_argument("Gaussian process: an input overflows in length scales");
    return rows;
}

Eigen::VectorXd covarianceColumn(const ScaledRows& rows, const Eigen::RowVectorXd& b,
                                 double signal2)
{
    Eigen::ArrayXd distance2 = Eigen::ArrayXd::Zero(rows.X.rows());
    for (Eigen::Index d = 0; d < rows.X.cols(); ++d)
        distance2 += ((rows.X.col(d).array() - b[d]) * rows.perLength[d]).square();
    return signal2 * (-0.5 * distance2).exp();
}

CovarianceBlock::CovarianceBlock(const ScaledRows& rows, double signal2)
    : d_(blasSize(rows.X.cols())), signal2_(signal2),
      rows_(entriesOf(rows.X.rows(), rows.X.cols())), perLength_(entriesOf(rows.X.cols(), 1)),
      zeros_(entriesOf(rows.X.rows(), 1)), z_(entriesOf(rows.X.cols(), kGroup)),
      block_(entriesOf(rows.X.rows(), kGroup)), unused_(kGroup)
{
    double* out = rows_.data();
    for (Eigen::Index u = 0; u < rows.X.rows(); ++u)
        for (Eigen::Index j = 0; j < rows.X.cols(); ++j) *out++ = rows.X(u, j);
    std::copy_n(rows.perLength.data(), d_, perLength_.data());
}

const double* CovarianceBlock::with(std::span<const int> columns, int rows)
{
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (int j = 0; j < d_; ++j)
            z_.data()[static_cast<std::size_t>(j) * kGroup + c] =
                rows_.data()[static_cast<long>(columns[c]) * d_ + j];
    const CovarianceInput in{
        rows_.data(), perLength_.data(), zeros_.data(), zeros_.data(), rows, rows, d_, signal2_};
    covarianceKernels().covariances(in, z_.data(), block_.data(), unused_.data());
    return block_.data();
}

}  // namespace terratact
