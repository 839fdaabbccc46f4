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

/// Least reciprocal condition number of a covariance that is used.
inline constexpr double kMinRcond = 1e-12;
/// Returns max(1e-9, 1e-14 / rcond), the relative error bound of results from a matrix with this
/// reciprocal condition number. Each result states its reference. It is at most 1e-2 if rcond is at
/// least kMinRcond.
double errorBoundAt(double rcond);
/// Share of the prior's variance below which rounding makes a predicted variance meaningless.
inline constexpr double kMinVariance = 1e-15;

/// Factor by which the error of a single-precision variance through all rows may exceed the error
/// at the probes.
inline constexpr double kSingleErrorElsewhere = 5.0;
/// Largest relative error of a variance in single precision: five times the limit at the probes.
inline constexpr double kSingleVarianceError = 1e-2;

/// Gaussian process regression with the squared exponential kernel of Hyperparameters (Rasmussen &
/// Williams 2006, ch. 2):
///   K = k(X, X) + σ_n² I = L Lᵀ,  α = K⁻¹ y
///   mean = ȳ + k★ᵀ α,  variance = σ_f² + σ_n² − |L⁻¹ k★|²     (eq. 2.25, 2.26; of the height, not of f)
/// K may be singular to working precision. Causes are repeated rows without noise, and length
/// scales beyond the data. K + jitter (σ_f² + σ_n²) I then replaces it, with the least sufficient
/// jitter of 1e-10, 1e-9 … 1e-6. The error of the mean is at most meanErrorBound(). The error of
/// the variance in double precision is at most errorBound() of σ_f² + σ_n². The variance is at
/// least σ_n² and kMinVariance (σ_f² + σ_n²). The object is immutable and may be shared between
/// threads. The inverse factor for variances is made at the first prediction in a precision
/// (InverseFactor).
class GaussianProcess {
public:
    /// X: U × d standardised inputs. y: U outputs, centred. outputMean: ȳ, added to every
    /// prediction. poll: as in cholesky.h; what it throws is rethrown, and nothing is built.
    /// Throws std::invalid_argument if sizes disagree, a number is not finite, or a length scale is
    /// not positive. It also throws if rcond() would be below kMinRcond with every jitter.
    /// rowVariance: variance of each output besides σ_n², added to K's diagonal; without rows: 0. A predicted
    /// variance is that of a height without it.
    GaussianProcess(Eigen::MatrixXd X, const Eigen::VectorXd& y, Hyperparameters hyper,
                    double outputMean, const Poll& poll = {}, Eigen::VectorXd rowVariance = {});

    /// Returns a process that predicts through at most `inducing` rows
    /// (core/learn/gp/sparse_process.h), faster by the square of rows() / inducing. Returns the
    /// exact process if inducing is rows() or more. Throws as the constructor, and for inducing <
    /// 1.
    static std::unique_ptr<GaussianProcess> sparse(Eigen::MatrixXd X, const Eigen::VectorXd& y,
                                                   int inducing, Hyperparameters hyper,
                                                   double outputMean, const Poll& poll = {},
                                                   Eigen::VectorXd rowVariance = {});

    /// Returns the number of rows that a prediction sums over: U, or the inducing rows.
    Eigen::Index rows() const { return X_.rows(); }
    Eigen::Index inputs() const { return X_.cols(); }
    const Hyperparameters& hyperparameters() const { return hyper_; }

    /// Returns the jitter on K's diagonal as a share of σ_f² + σ_n²; 0: none. Sparse process:
    /// SparseProcess::jitter.
    double jitter() const { return jitter_; }
    /// Returns the estimated reciprocal condition number of K with its jitter, 1-norm. Sparse
    /// process: SparseProcess::rcond.
    double rcond() const { return rcond_; }

    /// Returns errorBoundAt(rcond()). Measured errors were at most 0.4 of it where rcond() decides.
    double errorBound() const { return errorBoundAt(rcond_); }

    /// Returns errorBound() of σ_f² Σ |α_u|, the largest possible sum of the mean's terms. That is
    /// about max |y| for outputs as smooth as the length scales, and many times that for others.
    /// The rounding error of ȳ is not included.
    double meanErrorBound() const { return errorBound() * largestMean_; }

    /// Returns InverseFactor::Single::error of this process [m²].
    double singleError(const Poll& poll = {}) const { return inverse_->single(poll).error; }

    /// Returns the number of rows for a variance in single precision: all, or those that explain
    /// the others (ReducedVariance). A mean passes through all rows.
    int varianceRows(const Poll& poll = {}) const { return inverse_->single(poll).kept; }

    /// Returns the precision that a request for `wanted` gets. Single needs a singleError of at
    /// most 0.2 % of σ_n², the least possible variance, or of a reduced variance itself.
    /// The relative error of a single-precision variance is then at most kSingleVarianceError; a
    /// standard deviation has half of that. Through all rows its error is at most
    /// kSingleErrorElsewhere times singleError. tests/core/learn/model/bin_models_test.cpp shows
    /// the errors of the shipped model. A mean is the same except for rounding, because its sum has
    /// another order. A process with almost no noise, or an ill-conditioned one, is computed in
    /// double.
    /// poll: called while the inverse factor is made, see InverseFactor.
    Precision usable(Precision wanted, const Poll& poll = {}) const;

    /// Makes what the first prediction with that request would make.
    void prepare(Precision wanted, const Poll& poll = {}) const;

    /// Returns the prediction of the height at a standardised input x: d, in double precision.
    Normal predict(const Eigen::VectorXd& x) const;

private:
    friend class SceneConditional;
    Eigen::MatrixXd factor(const Poll& poll) const;
    std::optional<ReducedInverse> reduce(const Eigen::MatrixXd& R, const Poll& poll) const;

    /// Makes a sparse process over the rows Z.
    GaussianProcess(Eigen::MatrixXd Z, SparseProcess process, Hyperparameters hyper,
                    double outputMean, const Poll& poll);

    Eigen::MatrixXd X_;
    Hyperparameters hyper_;
    double outputMean_;
    Eigen::VectorXd rowVariance_;  // U, or empty
    double jitter_ = 0.0;
    double rcond_ = 1.0;
    Eigen::VectorXd alpha_;
    double largestMean_ = 0.0;              // σ_f² Σ |α_u|
    std::optional<InverseFactor> inverse_;  // inverse of L; F for a sparse process
};

/// Throws std::invalid_argument with a sentence unless X (U × d), y (U) and hyper fit each other.
/// Throws also unless U ≥ 1 and every number is in the range of GaussianProcess.
void requireTrainable(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                      const Hyperparameters& hyper);

/// Throws std::invalid_argument unless there is no row variance, or one of 0 or more for each row.
void requireRowVariance(const Eigen::VectorXd& rowVariance, Eigen::Index rows);

}  // namespace terratact
