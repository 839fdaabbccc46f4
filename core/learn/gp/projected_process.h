#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Gaussian process that is learnt from many rows through a few inducing rows Z. With K_mm = k(Z,
/// Z) + kProjectionJitter σ_f² I, K_mn = k(Z, X) and A = K_mm + σ_n⁻² K_mn K_nm:
///   mean(x) = k(x, Z) w,   w = σ_n⁻² A⁻¹ K_mn y
/// This is the projected process approximation (Rasmussen & Williams 2006, §8.3.4). With Z = X it
/// is the exact process, except for the jitter. The jitter is always added, because inducing rows
/// may nearly repeat.
struct ProjectedProcess {
    Eigen::VectorXd weights;  ///< w, one per inducing row
    /// yᵤ minus the mean predicted for row u without row u, with Z unchanged:
    ///   (yᵤ − mean(xᵤ)) / max(1 − H_uu, kMinFreedom),  H = σ_n⁻² K_nm A⁻¹ K_mn
    /// If rows share a place, minus the mean without all rows S of the place:
    ///   ((1 + kMinFreedom − H_SS)⁻¹ (y_S − mean(x_S)))ᵤ
    Eigen::VectorXd leaveOneOut;
    /// The smaller reciprocal condition number of K_mm and of L⁻¹ A L⁻ᵀ, with K_mm = L Lᵀ; 1-norm.
    double rcond = 1.0;

    /// Returns errorBoundAt(rcond) (gaussian_process.h). It bounds the relative error of the mean
    /// at a row, and of a numerator of leaveOneOut. Both are relative to the larger of max |y| and
    /// σ_f² Σ |w|. It also bounds the absolute error of the denominator.
    double errorBound() const;
};

/// Jitter on K_mm's diagonal, as a share of σ_f².
inline constexpr double kProjectionJitter = 1e-6;
/// Least value of 1 − H_uu: below it the residual of a row is only rounding.
inline constexpr double kMinFreedom = 1e-9;

/// Learns the process. X: n × d standardised inputs; y: n outputs, centred; inducing: rows of X.
/// places: one number per row, equal for rows of one place (scene_copies.h); empty: one row each.
/// Cost: n m² multiplications; memory: 2 n m doubles.
/// Throws std::invalid_argument if sizes disagree, a number is not finite, σ_n is 0 or a row does
/// not exist. It also throws if rcond would be below kMinRcond (gaussian_process.h). poll: called
/// every few milliseconds; what it throws is rethrown. rowVariance: variance s² of each output besides σ_n²; without
/// rows: 0. Each row then counts as with a noise of √(σ_n² + s²) in place of σ_n.
ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper,
                                const Poll& poll = {}, const std::vector<int>& places = {},
                                const Eigen::VectorXd& rowVariance = {});

}  // namespace terratact
