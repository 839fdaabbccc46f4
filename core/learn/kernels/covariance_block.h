#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Rows of inputs and the factors that scale their differences. Differences are scaled, not inputs:
/// scaled inputs have rounding errors of 2⁻⁵³ |x| / ℓ, which is much if ℓ is tiny.
struct ScaledRows {
    Eigen::MatrixXd X;             ///< n × d
    Eigen::RowVectorXd perLength;  ///< d: 1 / ℓ

    ScaledRows some(const std::vector<int>& rows) const { return {X(rows, Eigen::all), perLength}; }
};

/// Returns the scaled rows. Throws std::invalid_argument if 1 / ℓ or a scaled input overflows.
ScaledRows inLengthScales(Eigen::MatrixXd X, const Hyperparameters& hyper);

/// Returns signal² exp(−½ Σ_d ((a_d − b_d) / ℓ_d)²) for every row a.
Eigen::VectorXd covarianceColumn(const ScaledRows& rows, const Eigen::RowVectorXd& b,
                                 double signal2);

/// Covariances among the rows of one matrix by covarianceKernels(), up to kGroup columns at a time.
class CovarianceBlock {
public:
    CovarianceBlock(const ScaledRows& rows, double signal2);

    /// Returns the covariances of rows u < rows with each of at most kGroup columns, like
    /// covarianceColumn except for rounding. The result is rows × kGroup, row-major, and valid
    /// until the next call; unused columns are undefined.
    const double* with(std::span<const int> columns, int rows);

private:
    int d_;
    double signal2_;
    AlignedArray<double> rows_, perLength_, zeros_, z_, block_, unused_;
};

}  // namespace terratact
