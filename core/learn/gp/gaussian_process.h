#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "core/learn/gp/cholesky.h"
#include "core/learn/gp/inverse_factor.h"
#include "core/learn/kernels/hyperparameters.h"
#include "core/learn/kernels/precision.h"

namespace terratact {

struct SparseProcess;

/// A one-dimensional Gaussian.
struct Normal {
    double mean = 0.0;
    double variance = 0.0;
};

/// A covariance whose reciprocal condition number is below this is not trusted.
inline constexpr double kMinRcond = 1e-12;
/// max(1e-9, 1e-14 / rcond): how right results are that come from a matrix of that reciprocal condition number, as
/// a share of what each of them states.  At most 1e-2 where rcond is at least kMinRcond.
double errorBoundAt(double rcond);
/// Share of the prior's variance below which rounding leaves nothing of a predicted one.
inline constexpr double kMinVariance = 1e-15;

/// By how much a variance in single precision, through all rows, may be further off than where that is measured.
inline constexpr double kSingleErrorElsewhere = 5.0;
/// How far off a variance in single precision may be, as a share of itself: five times what it may be at the probes.
inline constexpr double kSingleVarianceError = 1e-2;

/// Gaussian process regression with the kernel of Hyperparameters (Rasmussen & Williams 2006, ch. 2):
///   K = k(X, X) + σ_n² I = L Lᵀ,  α = K⁻¹ y
///   mean = ȳ + k★ᵀ α,  variance = σ_f² + σ_n² − |L⁻¹ k★|²     (eq. 2.25, 2.26; of the height, not of f)
/// Where K is singular to working precision (doubled rows without noise, length scales beyond the data),
/// K + jitter (σ_f² + σ_n²) I takes its place, with the least jitter of 1e-10, 1e-9 … 1e-6 that mends it.
/// Mean and variance (in double precision) are right to meanErrorBound() and to errorBound() of σ_f² + σ_n².  The variance is at least σ_n² and never below kMinVariance (σ_f² + σ_n²).
/// Immutable once built; safe to share between threads.  What variances need of it is made at the first prediction in a precision (InverseFactor).
class GaussianProcess {
public:
    /// X: U × d standardised inputs; y: U outputs, centred; outputMean: ȳ, added to every prediction.
    /// poll: as in cholesky.h; what it throws comes out of here, and nothing is built.
    /// Throws std::invalid_argument if sizes disagree, a number is not finite, a length scale is not
    /// positive, or rcond() would be below kMinRcond with every jitter.
    GaussianProcess(Eigen::MatrixXd X, const Eigen::VectorXd& y, Hyperparameters hyper,
                    double outputMean, const Poll& poll = {});

    /// One that predicts through at most `inducing` of the rows (core/learn/gp/sparse_process.h): cheaper by the square
    /// of rows() / inducing.  The exact one where inducing is rows() or more.
    /// Throws as the constructor, and for inducing < 1.
    static std::unique_ptr<GaussianProcess> sparse(Eigen::MatrixXd X, const Eigen::VectorXd& y,
                                                   int inducing, Hyperparameters hyper,
                                                   double outputMean, const Poll& poll = {});

    /// Rows that a prediction sums over: U, or the inducing ones.
    Eigen::Index rows() const { return X_.rows(); }
    Eigen::Index inputs() const { return X_.cols(); }
    const Hyperparameters& hyperparameters() const { return hyper_; }

    /// Added to K's diagonal, as a share of σ_f² + σ_n²; 0 where K needed none.  Of a sparse one: SparseProcess::jitter.
    double jitter() const { return jitter_; }
    /// Estimated reciprocal condition number of K with its jitter, 1-norm.  Of a sparse one: SparseProcess::rcond.
    double rcond() const { return rcond_; }

    /// At rcond().  Seen were up to 0.4 of that where rcond() decides.
    double errorBound() const { return errorBoundAt(rcond_); }

    /// errorBound() of σ_f² Σ |α_u|, the most that a mean's terms could add up to: about max |y| where outputs vary as
    /// smoothly as the length scales say, and many times that where they do not.  Rounding of ȳ comes on top.
    double meanErrorBound() const { return errorBound() * largestMean_; }

    /// InverseFactor::Single::error of this process [m²].
    double singleError(const Poll& poll = {}) const { return inverse_->single(poll).error; }

    /// Rows that a variance in single precision goes through: all, or those that explain the others
    /// (ReducedVariance); a mean goes through all.
    int varianceRows(const Poll& poll = {}) const { return inverse_->single(poll).kept; }

    /// The precision that a wish for `wanted` gets: single only where singleError is at most 0.2 % of σ_n², the
    /// least a variance can be, or of a reduced variance itself.  A variance in single precision is then off by at most kSingleVarianceError of
    /// itself, or half of that of a standard deviation; through all rows by at most kSingleErrorElsewhere times
    /// singleError.  (Of the shipped model: tests/core/learn/model/bin_models_test.cpp.)  A mean is the same but for
    /// rounding: its sum has another order.  A process with next to no noise, or ill-conditioned, is computed in double.
    /// poll: while that is made, see InverseFactor.
    Precision usable(Precision wanted, const Poll& poll = {}) const;

    /// Makes what the first prediction with that wish would make.
    void prepare(Precision wanted, const Poll& poll = {}) const;

    /// Of the height at a standardised input x: d.  In double precision.
    Normal predict(const Eigen::VectorXd& x) const;

private:
    friend class SceneConditional;
    Eigen::MatrixXd factor(const Poll& poll) const;
    std::optional<ReducedInverse> reduce(const Eigen::MatrixXd& R, const Poll& poll) const;

    /// From a sparse process over the rows Z.
    GaussianProcess(Eigen::MatrixXd Z, SparseProcess process, Hyperparameters hyper,
                    double outputMean, const Poll& poll);

    Eigen::MatrixXd X_;
    Hyperparameters hyper_;
    double outputMean_;
    double jitter_ = 0.0;
    double rcond_ = 1.0;
    Eigen::VectorXd alpha_;
    double largestMean_ = 0.0;              // σ_f² Σ |α_u|
    std::optional<InverseFactor> inverse_;  // of L, or F of a sparse one
};

/// Throws std::invalid_argument, a sentence, unless X: U × d, y: U and hyper fit each other, U ≥ 1 and every
/// number is in the range that GaussianProcess asks for.
void requireTrainable(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                      const Hyperparameters& hyper);

}  // namespace terratact
