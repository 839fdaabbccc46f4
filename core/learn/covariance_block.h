#pragma once

#include <Eigen/Core>
#include <span>

#include "core/learn/aligned_array.h"
#include "core/learn/hyperparameters.h"

namespace terratact {

/// X: U × d in units of hyper's length scales.  Throws std::invalid_argument where that overflows.
Eigen::MatrixXd inLengthScales(const Eigen::MatrixXd& X, const Hyperparameters& hyper);

/// Covariances among the rows of one matrix, up to kGroup columns at a time, by covarianceKernels().
class CovarianceBlock {
public:
    /// scaled: n × d, see inLengthScales.
    CovarianceBlock(const Eigen::MatrixXd& scaled, double signal2);

    /// signal² exp(−½ |x_u − x_v|²) for u < rows and each v of `columns`, at most kGroup of them.
    /// rows × kGroup, row-major, valid until the next call; what is behind the last of the columns is undefined.
    const double* with(std::span<const int> columns, int rows);

private:
    int d_;
    double signal2_;
    AlignedArray<double> rows_, zeros_, z_, block_, unused_;
};

}  // namespace terratact
