#pragma once

#include <Eigen/Core>

#include "core/base/poll.h"

namespace terratact {

/// Largest work between two polls, here and below: some milliseconds of arithmetic or memory
/// access.
inline constexpr double kMaxMultiplications = 2e7;
inline constexpr long kMaxRead = 1L << 20;  ///< numbers, each read once

/// Returns the number of rows or columns between two polls; each: multiplications per row or
/// column.
inline Eigen::Index linesAtOnce(Eigen::Index each)
{
    const auto multiplications = static_cast<double>(each > 0 ? each : 1);
    const auto lines = static_cast<Eigen::Index>(kMaxMultiplications / multiplications);
    return lines > 0 ? lines : 1;
}

/// Factorises K = Rᵀ R in place: R in the upper triangle; the lower triangle is neither read nor
/// changed. Returns false if K is not positive definite or holds a value that is not finite; K is
/// then undefined.
bool choleskyUpper(Eigen::MatrixXd& K, const Poll& poll = {});

/// R := R⁻¹ in place, upper triangle; every diagonal element must differ from 0.
void invertUpper(Eigen::MatrixXd& R, const Poll& poll = {});

/// y := K⁻¹ y from R.
void solveWithFactor(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll = {});

/// B := Uᵀ B for an upper triangle U and at most 16 columns.
void multiplyTransposed(const Eigen::MatrixXd& U, Eigen::MatrixXd& B, const Poll& poll = {});

/// B := R⁻ᵀ B for at most 16 columns.
void solveTransposed(const Eigen::MatrixXd& R, Eigen::MatrixXd& B, const Poll& poll = {});

/// Returns an estimate of 1 / (‖K‖₁ ‖K⁻¹‖₁) from R and norm = ‖K‖₁. It is never below the true
/// value, and seldom above three times it. Returns 0 if K⁻¹ overflows.
/// Source: Higham, ACM TOMS 14 (1988), algorithm 674; LAPACK's dlacn2.
double reciprocalCondition(const Eigen::MatrixXd& R, double norm, const Poll& poll = {});

/// Returns ‖K‖₁ of a symmetric matrix from its upper triangle.
double symmetricNorm(const Eigen::MatrixXd& K, const Poll& poll = {});

}  // namespace terratact
