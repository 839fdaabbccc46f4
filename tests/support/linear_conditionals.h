#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/infer/sampling/conditionals.h"

namespace terratact {

/// Conditionals whose mean is linear in the other bins, each with one sd:
///   xᵢ | x_{J∖i} ~ N(interceptᵢ + Σ_j weights_ij x_j, sdᵢ²).
/// Chains start from N(startMeanᵢ, startSdᵢ²).
class LinearConditionals : public Conditionals {
public:
    Eigen::VectorXd intercept, sd;       ///< 11
    Eigen::MatrixXd weights;             ///< 11 × 11 with zero diagonal
    Eigen::VectorXd startMean, startSd;  ///< 11

    StartDraw start(int bin) const override;
    std::unique_ptr<SceneConditionals> at(const Heights& known,
                                          const std::vector<int>& unknown) const override;
};

/// Returns the conditionals of N(mean, covariance): with P = covariance⁻¹, weights_ij = −P_ij / P_ii and sdᵢ² = 1 /
/// P_ii (Rasmussen & Williams 2006, eq. A.6 in terms of the precision). Chains start from the marginals.
LinearConditionals exactConditionals(const Eigen::VectorXd& mean,
                                     const Eigen::MatrixXd& covariance);

}  // namespace terratact
