#pragma once

#include <Eigen/Core>

namespace terratact {

/// Eigenvalues, ascending, and orthonormal eigenvectors, one per column.
struct SymmetricEigen {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Returns the decomposition A = V diag(values) Vᵀ of a symmetric matrix. It reads the lower triangle. The signs of the
/// eigenvectors are arbitrary.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& symmetric);

}  // namespace terratact
