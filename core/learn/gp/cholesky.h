#pragma once

#include <Eigen/Core>

#include "core/base/poll.h"

namespace terratact {

/// What lies between two polls at most, here and below: some milliseconds of arithmetic, or of memory's.
inline constexpr double kMaxMultiplications = 2e7;
inline constexpr long kMaxRead = 1L << 20;  ///< numbers, each read once

/// Rows or columns of a product with so many multiplications each that lie between two polls.
inline Eigen::Index linesAtOnce(Eigen::Index each)
{
    const auto multiplications = static_cast<double>(each > 0 ? each : 1);
    const auto lines = static_cast<Eigen::Index>(kMaxMultiplications / multiplications);
    return lines > 0 ? lines : 1;
}

/// Factorises K = Rᵀ R in place: R in the upper triangle, the lower one is not read and not changed.
/// False where K is not positive definite or holds a value that is not finite; K is then spoilt.
bool choleskyUpper(Eigen::MatrixXd& K, const Poll& poll = {});

/// R := R⁻¹ in place, upper triangle; every diagonal element must be other than 0.  Polls likewise.
void invertUpper(Eigen::MatrixXd& R, const Poll& poll = {});

/// y := K⁻¹ y from R.  Polls likewise.
void solveWithFactor(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll = {});

/// B := Uᵀ B for an upper triangle U and at most 16 columns.  Polls likewise.
void multiplyTransposed(const Eigen::MatrixXd& U, Eigen::MatrixXd& B, const Poll& poll = {});

/// B := R⁻ᵀ B for at most 16 columns.  Polls likewise.
void solveTransposed(const Eigen::MatrixXd& R, Eigen::MatrixXd& B, const Poll& poll = {});

/// Estimate of 1 / (‖K‖₁ ‖K⁻¹‖₁) from R and norm = ‖K‖₁: never below the truth, seldom above three times it;
/// 0 where K⁻¹ overflows.
/// Source: Higham, ACM TOMS 14 (1988), algorithm 674; LAPACK's dlacn2.
double reciprocalCondition(const Eigen::MatrixXd& R, double norm, const Poll& poll = {});

/// ‖K‖₁ of a symmetric matrix from its upper triangle.
double symmetricNorm(const Eigen::MatrixXd& K, const Poll& poll = {});

}  // namespace terratact
