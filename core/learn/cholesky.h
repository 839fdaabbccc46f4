#pragma once

#include <Eigen/Core>
#include <functional>

namespace terratact {

/// Called every few milliseconds by a long computation; what it throws ends the computation.
using Poll = std::function<void()>;

/// Factorises K = Rᵀ R in place: R in the upper triangle, the lower one is not read and not changed.
/// False where K is not positive definite or holds a value that is not finite; K is then spoilt.
/// Blocked, so that between two polls lie at most about 1e8 multiplications.
bool choleskyUpper(Eigen::MatrixXd& K, const Poll& poll = {});

/// R := R⁻¹ in place, upper triangle; every diagonal element must be other than 0.  Polls likewise.
void invertUpper(Eigen::MatrixXd& R, const Poll& poll = {});

/// Estimate of 1 / (‖K‖₁ ‖K⁻¹‖₁) from R and norm = ‖K‖₁: never below the truth, seldom above three times it;
/// 0 where K⁻¹ overflows.
/// Source: Higham, ACM TOMS 14 (1988), algorithm 674; LAPACK's dlacn2.
double reciprocalCondition(const Eigen::MatrixXd& R, double norm, const Poll& poll = {});

/// ‖K‖₁ of a symmetric matrix from its upper triangle.
double symmetricNorm(const Eigen::MatrixXd& K);

}  // namespace terratact
