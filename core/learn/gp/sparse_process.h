#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/learn/gp/cholesky.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// A Gaussian process learnt from all rows, predicting through m inducing rows Z of them.  With K_mm = k(Z, Z),
/// K_mn = k(Z, X), Λ = diag(k(X, X) − K_nm K_mm⁻¹ K_mn) + (σ_n² + jitter (σ_f² + σ_n²)) I and
/// A = K_mm + K_mn Λ⁻¹ K_nm:
///   mean = k_mᵀ w,  w = A⁻¹ K_mn Λ⁻¹ y,   variance = σ_f² + σ_n² − |F k_m|²,  Fᵀ F = K_mm⁻¹ − A⁻¹
/// The fully independent training conditional (Snelson & Ghahramani 2005; Rasmussen & Williams 2006, §8.3.4
/// has it without the first part of Λ); exact where every row is one of Z.
struct SparseProcess {
    std::vector<int> inducing;  ///< rows of X, in the order chosen
    Eigen::VectorXd weights;    ///< w: m
    Eigen::MatrixXd F;          ///< m × m, lower triangle, zeros above
    /// Where σ_n² is below 1e-9 σ_f², what makes up for the difference; 0 elsewhere.
    double jitter = 0.0;
    /// The least of the reciprocal condition numbers (1-norm, estimated) of K_mm and of L⁻¹ A L⁻ᵀ, K_mm = L Lᵀ, and of
    /// Λ, a difference, as a share of σ_f² + σ_n².
    double rcond = 1.0;
};

/// At most `count` inducing rows (core/learn/gp/inducing_rows.h), fewer where those explain every row or where the next ones
/// would make K_mm singular, among at most 4 · count evenly spread rows.
///   X: n × d standardised, y: n centred.  Cost: n m² + 2 m³ multiplications; memory: 2 n m doubles.
/// poll: as in cholesky.h; what it throws comes out of here.
/// Throws std::invalid_argument as requireTrainable, for count < 1, for numbers that overflow, and where rcond would
/// be below kMinRcond (gaussian_process.h).
SparseProcess sparseProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, int count,
                            const Hyperparameters& hyper, const Poll& poll = {});

/// Rows that explain all others so well that variances need no more of them, and |F k_m|², which then takes the
/// place of kᵀ (k(X, X) + σ_n² 1)⁻¹ k: F as in SparseProcess.
struct ReducedVariance {
    std::vector<int> rows;  ///< of X, in the order chosen
    Eigen::MatrixXd F;      ///< m × m, lower triangle, zeros above
};

/// Of σ_n²: what may be left of the variance of a row, given the inducing rows.
inline constexpr double kUnexplainedOfNoise = 1e-4;

/// Of σ_n²: what the rows that are left out may still say together, the largest eigenvalue of k(X, X) − V Vᵀ
/// (InducingRows).  Many that each say next to nothing may all say the same.  The variance of a prediction is then off by
/// about that share of itself at most.
inline constexpr double kLeftTogether = 1e-2;

/// None where that takes more than 92 % of the rows, or no row, where half as many explain too little for that, where the
/// rows left out say more than kLeftTogether, or where σ_n² is too small to judge by (below 1e-4 σ_f²).
/// X, hyper: of a GaussianProcess.  Cost: n m² + m³ + (n − m)² m multiplications; memory: 0.92 n² doubles, n m of them used, and
/// (n − m) n more or 4 m².
std::optional<ReducedVariance> reducedVariance(const Eigen::MatrixXd& X,
                                               const Hyperparameters& hyper, const Poll& poll = {});

}  // namespace terratact
