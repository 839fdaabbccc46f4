#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/learn/aligned_array.h"
#include "core/learn/covariance_kernels.h"
#include "core/learn/hyperparameters.h"
#include "core/learn/inverse_factor.h"
#include "core/learn/precision.h"

namespace terratact {

/// A one-dimensional Gaussian.
struct Normal {
    double mean = 0.0;
    double variance = 0.0;
};

/// Gaussian process regression with the kernel of Hyperparameters (Rasmussen & Williams 2006, ch. 2):
///   K = k(X, X) + σ_n² I = L Lᵀ,  α = K⁻¹ y
///   mean = ȳ + k★ᵀ α,  variance = σ_f² + σ_n² − |L⁻¹ k★|²     (eq. 2.25, 2.26; of the height, not of f)
/// Immutable once built; safe to share between threads.  L⁻¹ is inverted and packed at the first prediction.
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

    /// InverseFactor::singleError of this process [m²].  Elsewhere a variance was seen to be off by up to three
    /// times as much, and a standard deviation of the shipped model by up to 6e-6 m (heights).
    double singleError() const { return inverse_->singleError(); }

    /// The precision that a wish for `wanted` gets: single only where singleError is at most 0.2 % of σ_n², the
    /// least a variance can be, which is 0.1 % of a standard deviation.  A process with next to no noise, or
    /// ill-conditioned, is computed in double.
    Precision usable(Precision wanted) const;

    /// Of the height at a standardised input x: d.  In double precision.
    Normal predict(const Eigen::VectorXd& x) const;

private:
    friend class SceneConditional;
    Eigen::MatrixXd factor() const;

    Eigen::MatrixXd X_;
    Hyperparameters hyper_;
    double outputMean_;
    Eigen::VectorXd alpha_;
    std::optional<InverseFactor> inverse_;
};

/// A Gaussian process at one scene: the inputs that stay fixed are folded into one log weight per
/// training row, so a prediction costs only the inputs that move.
class SceneConditional {
public:
    /// x: d standardised input; moving: indices of inputs that will be given anew for each prediction.
    /// precision: of the variance, where usable() grants it; the mean is double in both.
    SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x, std::vector<int> moving,
                     Precision precision, const CovarianceKernels& kernels = covarianceKernels());

    /// Predicts for several settings of the moving inputs at once.  A column's result does not depend on
    /// the others.  inputs: moving.size() × n standardised; mean, variance: n.
    void predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean, Eigen::VectorXd& variance);

private:
    void makeRoom(int groups);
    void scaleInputs(const Eigen::MatrixXd& inputs);
    void meansAndSquares(int groups);

    const GaussianProcess& gp_;
    const CovarianceKernels& kernels_;
    std::vector<int> moving_;
    AlignedArray<double> scaledX_;            // U × m, row-major, in length scales
    AlignedArray<double> logWeight_, alpha_;  // U
    AlignedArray<double> scaledZ_, mean_, squares_;
    const double* panels_ = nullptr;       // of the precision that is used; the other one is null
    const float* panelsSingle_ = nullptr;  // likewise
    AlignedArray<double> double_;          // covariances, see CovarianceKernels
    AlignedArray<float> single_;           // likewise
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
