#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/learn/hyperparameters.h"

namespace terratact {

/// A one-dimensional Gaussian.
struct Normal {
    double mean = 0.0;
    double variance = 0.0;
};

/// Doubles aligned for vector loads.
struct AlignedDoubles {
    explicit AlignedDoubles(std::size_t size = 0)
        : values(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size) + 8))
    {
    }
    double* data();
    const double* data() const;
    Eigen::VectorXd values;
};

/// Gaussian process regression with the kernel of Hyperparameters (Rasmussen & Williams 2006, ch. 2):
///   K = k(X, X) + σ_n² I = L Lᵀ,  α = K⁻¹ y
///   mean = ȳ + k★ᵀ α,  variance = σ_f² + σ_n² − |L⁻¹ k★|²     (eq. 2.25, 2.26; of the height, not of f)
/// Immutable once built; safe to share between threads.
class GaussianProcess {
public:
    /// X: U × d standardised inputs; y: U outputs, centred; outputMean: ȳ, added to every prediction.
    /// Throws std::invalid_argument if sizes disagree, a number is not finite, a length scale is not
    /// positive, or K is not positive definite (doubled rows without noise).
    GaussianProcess(Eigen::MatrixXd X, const Eigen::VectorXd& y, Hyperparameters hyper,
                    double outputMean);

    Eigen::Index rows() const { return X_.rows(); }
    Eigen::Index inputs() const { return X_.cols(); }
    const Hyperparameters& hyperparameters() const { return hyper_; }

    /// Of the height at a standardised input x: d.
    Normal predict(const Eigen::VectorXd& x) const;

private:
    friend class SceneConditional;

    Eigen::MatrixXd X_;
    Hyperparameters hyper_;
    double outputMean_;
    Eigen::VectorXd alpha_;
    int paddedRows_;
    AlignedDoubles panels_;  // L⁻¹ in panels of kPanelRows rows, see CovarianceKernels
};

/// A Gaussian process at one scene: the inputs that stay fixed are folded into one log weight per
/// training row, so a prediction costs only the inputs that move.
class SceneConditional {
public:
    /// x: d standardised input; moving: indices of inputs that will be given anew for each prediction.
    SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x, std::vector<int> moving);

    /// Predicts for several settings of the moving inputs at once.
    ///   inputs: moving.size() × n standardised; mean, variance: n.
    void predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean, Eigen::VectorXd& variance);

private:
    const GaussianProcess& gp_;
    std::vector<int> moving_;
    AlignedDoubles scaledX_;    // U × m, row-major, in length scales
    AlignedDoubles logWeight_;  // U
    AlignedDoubles scaledZ_, covariance_, squares_;
};

/// Value and gradient of the negative log marginal likelihood.
struct Likelihood {
    double negativeLog = 0.0;
    Eigen::VectorXd gradient;  ///< d + 2: by log ℓ_1 … log ℓ_d, log σ_f, log σ_n
};

/// −log p(y | X) = ½ yᵀ α + Σ log L_ii + ½ U log 2π (eq. 2.30) and its gradient
/// ½ tr((K⁻¹ − α αᵀ) ∂K/∂θ) (eq. 5.9).  Memory: 2 U² doubles.
/// Throws as the constructor of GaussianProcess.
Likelihood negativeLogLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                 const Hyperparameters& hyper);

}  // namespace terratact
