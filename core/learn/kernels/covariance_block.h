#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Rows of inputs, and what turns their differences into length scales: differences come first, for inputs in length
/// scales round by 2⁻⁵³ |x| / ℓ of them, which is much where ℓ is tiny.
struct ScaledRows {
    Eigen::MatrixXd X;             ///< n × d
    Eigen::RowVectorXd perLength;  ///< d: 1 / ℓ

    ScaledRows some(const std::vector<int>& rows) const { return {X(rows, Eigen::all), perLength}; }
};

/// Throws std::invalid_argument where 1 / ℓ or an input in length scales overflows.
ScaledRows inLengthScales(Eigen::MatrixXd X, const Hyperparameters& hyper);

/// signal² exp(−½ Σ_d ((a_d − b_d) / ℓ_d)²) for every row a.
Eigen::VectorXd covarianceColumn(const ScaledRows& rows, const Eigen::RowVectorXd& b,
                                 double signal2);

/// Covariances among the rows of one matrix, up to kGroup columns at a time, by covarianceKernels().
class CovarianceBlock {
public:
    CovarianceBlock(const ScaledRows& rows, double signal2);

    /// What covarianceColumn gives, but for rounding, for u < rows and each v of `columns`, at most kGroup of them.
    /// rows × kGroup, row-major, valid until the next call; what is behind the last of the columns is undefined.
    const double* with(std::span<const int> columns, int rows);

private:
    int d_;
    double signal2_;
    AlignedArray<double> rows_, perLength_, zeros_, z_, block_, unused_;
};

}  // namespace terratact
