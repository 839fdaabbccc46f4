#pragma once

#include <Eigen/Core>

#include "core/base/poll.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Value and gradient of the negative log marginal likelihood.
struct Likelihood {
    double negativeLog = 0.0;
    Eigen::VectorXd gradient;  ///< d + 2: derivatives by log ℓ_1 … log ℓ_d, log σ_f, log σ_n
};

/// Returns −log p(y | X) = ½ yᵀ α + ½ log det K + ½ U log 2π. Also returns its gradient ½ tr((K⁻¹ − α αᵀ) ∂K/∂θ). K and
/// α are those of GaussianProcess. Source: Rasmussen & Williams 2006, eq. 2.30 and 5.9.
/// The error of value and gradient is at most errorBoundAt (gaussian_process.h) of U + yᵀ α, at K's
/// reciprocal condition number. Cost: U³ multiplications and additions; memory: ½ U² + (270 + d) U
/// doubles (SymmetricPanels).
/// Throws std::invalid_argument as requireTrainable, and if K is singular to working precision or
/// the value overflows. There is no jitter, because the search must see a singular K.
/// poll: called every few milliseconds; what it throws is rethrown. rowVariance: variance of each output besides
/// σ_n², as in GaussianProcess; without rows: 0.
Likelihood negativeLogLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                 const Hyperparameters& hyper, const Poll& poll = {},
                                 const Eigen::VectorXd& rowVariance = {});

}  // namespace terratact
