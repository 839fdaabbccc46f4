#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// A Gaussian process learnt from many rows through a few of them, the inducing rows Z.  With
/// K_mm = k(Z, Z) + kProjectionJitter σ_f² I, K_mn = k(Z, X) and A = K_mm + σ_n⁻² K_mn K_nm:
///   mean(x) = k(x, Z) w,   w = σ_n⁻² A⁻¹ K_mn y
/// The projected process approximation (Rasmussen & Williams 2006, §8.3.4); where Z = X, and but for the jitter, the
/// exact process.  The jitter is always there: inducing rows may nearly repeat.
struct ProjectedProcess {
    Eigen::VectorXd weights;  ///< w, one per inducing row
    /// yᵤ minus the mean predicted for row u without row u:
    ///   (yᵤ − mean(xᵤ)) / max(1 − H_uu, kMinFreedom),  H = σ_n⁻² K_nm A⁻¹ K_mn   (Z stays)
    Eigen::VectorXd leaveOneOut;
    double rcond =
        1.0;  ///< the lesser reciprocal condition number of K_mm and of L⁻¹ A L⁻ᵀ, K_mm = L Lᵀ; 1-norm

    /// errorBoundAt(rcond) (gaussian_process.h).  The mean at a row is right to that of max |y| or of σ_f² Σ |w|, whichever
    /// is more, a numerator of leaveOneOut likewise, and its denominator to that itself.
    double errorBound() const;
};

/// Share of σ_f² on K_mm's diagonal.
inline constexpr double kProjectionJitter = 1e-6;
/// Of 1 − H_uu: a row that the others leave less to say has no residual but rounding.
inline constexpr double kMinFreedom = 1e-9;

/// X: n × d standardised inputs; y: n outputs, centred; inducing: rows of X.
/// Cost: n m² multiplications; memory: 2 n m doubles.
/// Throws std::invalid_argument if sizes disagree, a number is not finite, σ_n is 0, a row does not exist
/// or rcond would be below kMinRcond (gaussian_process.h).  poll: every few milliseconds; what it throws comes out.
ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper,
                                const Poll& poll = {});

}  // namespace terratact
