#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/learn/gp/cholesky.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Sparse Gaussian process that is learnt from all rows and predicts through m inducing rows Z.
///   K_mm = k(Z, Z),  K_mn = k(Z, X),  A = K_mm + K_mn Λ⁻¹ K_nm
///   Λ = diag(k(X, X) − K_nm K_mm⁻¹ K_mn) + (σ_n² + jitter (σ_f² + σ_n²)) I
///   mean = k_mᵀ w,  w = A⁻¹ K_mn Λ⁻¹ y,   variance = σ_f² + σ_n² − |F k_m|²,  Fᵀ F = K_mm⁻¹ − A⁻¹
/// This is the fully independent training conditional (Snelson & Ghahramani 2005). Rasmussen &
/// Williams 2006, §8.3.4 give it without the first part of Λ. It is exact if every row belongs to
/// Z.
struct SparseProcess {
    std::vector<int> inducing;  ///< rows of X, in the order chosen
    Eigen::VectorXd weights;    ///< w: m
    Eigen::MatrixXd F;          ///< m × m, lower triangle, zeros above
    /// Raises a σ_n² below 1e-9 σ_f² to that value; else 0.
    double jitter = 0.0;
    /// Smallest of three numbers. Two are the estimated reciprocal condition numbers (1-norm) of
    /// K_mm and of L⁻¹ A L⁻ᵀ, with K_mm = L Lᵀ. The third is Λ as a share of σ_f² + σ_n², because Λ
    /// is a difference.
    double rcond = 1.0;
};

/// Learns the process with at most `count` inducing rows (core/learn/gp/inducing_rows.h), chosen
/// among at most 4 · count evenly spread rows. It takes fewer if these explain every row, or if the
/// next ones would make K_mm singular.
///   X: n × d standardised, y: n centred.  Cost: n m² + 2 m³ multiplications; memory: 2 n m doubles.
/// poll: as in cholesky.h; what it throws is rethrown. rowVariance: as in GaussianProcess; it is part of Λ.
/// Throws std::invalid_argument as requireTrainable, for count < 1, for numbers that overflow, and
/// if rcond would be below kMinRcond (gaussian_process.h).
SparseProcess sparseProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, int count,
                            const Hyperparameters& hyper, const Poll& poll = {},
                            const Eigen::VectorXd& rowVariance = {});

/// Rows that explain all others so well that variances need no more rows. |F k_m|², with F as in
/// SparseProcess, then replaces kᵀ (k(X, X) + σ_n² 1)⁻¹ k.
struct ReducedVariance {
    std::vector<int> rows;  ///< rows of X, in the order chosen
    Eigen::MatrixXd F;      ///< m × m, lower triangle, zeros above
};

/// Largest remaining variance of a row given the inducing rows, as a share of σ_n².
inline constexpr double kUnexplainedOfNoise = 1e-4;

/// Largest eigenvalue of k(X, X) − V Vᵀ (InducingRows) as a share of σ_n²: what the remaining rows
/// may still explain together. Many rows that each explain little may all explain the same. The
/// relative error of a predicted variance is about this share at most.
inline constexpr double kLeftTogether = 1e-2;

/// Returns nothing if it needs none or over 92 % of the rows, or if half as many explain too
/// little. It also returns nothing if the remaining rows explain more than kLeftTogether, or if
/// σ_n² is below 1e-4 σ_f². X, hyper: of a GaussianProcess. Cost: n m² + m³ + (n − m)² m
/// multiplications. Memory: 0.92 n² doubles, n m of them used, and (n − m) n more or 4 m².
std::optional<ReducedVariance> reducedVariance(const Eigen::MatrixXd& X,
                                               const Hyperparameters& hyper, const Poll& poll = {});

}  // namespace terratact
