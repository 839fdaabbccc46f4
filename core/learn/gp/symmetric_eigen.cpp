#include "core/learn/gp/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace terratact {

SymmetricEigen symmetricEigen(const Eigen::MatrixXd& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace terratact
