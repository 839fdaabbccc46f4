#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/learn/hyperparameters.h"

namespace terratact {

/// A Gaussian process learnt from many rows through a few of them, the inducing rows Z.  With
/// K_mm = k(Z, Z), K_mn = k(Z, X) and A = K_mm + σ_n⁻² K_mn K_nm:
///   mean(x) = k(x, Z) w,   w = σ_n⁻² A⁻¹ K_mn y
/// The projected process approximation (Rasmussen & Williams 2006, §8.3.4); exact where Z = X.
struct ProjectedProcess {
    Eigen::VectorXd weights;  ///< w, one per inducing row
    /// yᵤ minus the mean predicted for row u without row u:
    ///   (yᵤ − mean(xᵤ)) / (1 − H_uu),  H = σ_n⁻² K_nm A⁻¹ K_mn   (Z stays)
    Eigen::VectorXd leaveOneOut;
};

/// X: n × d standardised inputs; y: n outputs, centred; inducing: rows of X.
/// Cost: n m² multiplications; memory: 2 n m doubles.
/// Throws std::invalid_argument if sizes disagree, a number is not finite, σ_n is 0 or a row does not exist.
ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper);

}  // namespace terratact
