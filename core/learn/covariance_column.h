#pragma once

#include <Eigen/Core>

namespace terratact {

/// signal² exp(−½ |a − b|²) for every row a of A, all in length scales.  By differences: |a|² + |b|² − 2 a·b would
/// cancel where length scales are tiny.
inline Eigen::VectorXd covarianceColumn(const Eigen::MatrixXd& A, const Eigen::RowVectorXd& b,
                                        double signal2)
{
    Eigen::ArrayXd distance2 = Eigen::ArrayXd::Zero(A.rows());
    for (Eigen::Index d = 0; d < A.cols(); ++d) distance2 += (A.col(d).array() - b[d]).square();
    return signal2 * (-0.5 * distance2).exp();
}

}  // namespace terratact
