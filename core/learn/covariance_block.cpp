#include "core/learn/covariance_block.h"

#include <stdexcept>

#include "core/learn/blas_size.h"
#include "core/learn/covariance_kernels.h"

namespace terratact {

namespace {

std::size_t area(Eigen::Index a, Eigen::Index b)
{
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

}  // namespace

Eigen::MatrixXd inLengthScales(const Eigen::MatrixXd& X, const Hyperparameters& hyper)
{
    Eigen::MatrixXd scaled = X.array().rowwise() / hyper.lengthScale.transpose().array();
    if (!scaled.allFinite())
        throw std::invalid_argument("Gaussian process: an input overflows in length scales");
    return scaled;
}

CovarianceBlock::CovarianceBlock(const Eigen::MatrixXd& scaled, double signal2)
    : d_(blasSize(scaled.cols())), signal2_(signal2), rows_(area(scaled.rows(), scaled.cols())),
      zeros_(area(scaled.rows(), 1)), z_(area(scaled.cols(), kGroup)),
      block_(area(scaled.rows(), kGroup)), unused_(kGroup)
{
    double* out = rows_.data();
    for (Eigen::Index u = 0; u < scaled.rows(); ++u)
        for (Eigen::Index j = 0; j < scaled.cols(); ++j) *out++ = scaled(u, j);
}

const double* CovarianceBlock::with(std::span<const int> columns, int rows)
{
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (int j = 0; j < d_; ++j)
            z_.data()[static_cast<std::size_t>(j) * kGroup + c] =
                rows_.data()[static_cast<long>(columns[c]) * d_ + j];
    const CovarianceInput in{rows_.data(), zeros_.data(), zeros_.data(), rows, rows, d_, signal2_};
    covarianceKernels().covariances(in, z_.data(), block_.data(), unused_.data());
    return block_.data();
}

}  // namespace terratact
