#include "core/learn/projected_process.h"

#include <cblas.h>
#include <lapacke.h>

#include <cmath>
#include <stdexcept>

namespace terratact {

namespace {

constexpr double kJitter =
    1e-6;  // share of σ_f² on K_mm's diagonal: inducing rows may nearly repeat

int size(Eigen::Index n)
{
    return static_cast<int>(n);
}

void check(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const std::vector<int>& inducing,
           const Hyperparameters& hyper)
{
    if (X.rows() != y.size() || X.cols() != hyper.lengthScale.size() || inducing.empty())
        throw std::invalid_argument("projected process: sizes disagree or no inducing row");
    if (!X.allFinite() || !y.allFinite() || !(hyper.lengthScale.array() > 0.0).all())
        throw std::invalid_argument(
            "projected process: numbers must be finite and length scales positive");
    if (!(hyper.noiseSd > 0.0) || !(hyper.signalSd > 0.0))
        throw std::invalid_argument("projected process: σ_f and σ_n must be positive");
    for (const int row : inducing)
        if (row < 0 || row >= X.rows())
            throw std::invalid_argument("projected process: an inducing row does not exist");
}

/// k(A, B) for rows in length scales.
Eigen::MatrixXd covariance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double signalSd)
{
    Eigen::MatrixXd K(A.rows(), B.rows());
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, size(A.rows()), size(B.rows()),
                size(A.cols()), 1.0, A.data(), size(A.rows()), B.data(), size(B.rows()), 0.0,
                K.data(), size(K.rows()));
    K.colwise() -= 0.5 * A.rowwise().squaredNorm();
    K.rowwise() -= 0.5 * B.rowwise().squaredNorm().transpose();
    K = signalSd * signalSd * K.array().min(0.0).exp();
    return K;
}

/// Cholesky factor in the lower triangle, in place.
void factorise(Eigen::MatrixXd& K)
{
    if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', size(K.rows()), K.data(), size(K.rows())) != 0)
        throw std::invalid_argument("projected process: K is not positive definite");
}

/// B := L⁻¹ B.
void solveLower(const Eigen::MatrixXd& L, Eigen::MatrixXd& B)
{
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, size(B.rows()),
                size(B.cols()), 1.0, L.data(), size(L.rows()), B.data(), size(B.rows()));
}

}  // namespace

ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper)
{
    check(X, y, inducing, hyper);
    const Eigen::MatrixXd scaled = X.array().rowwise() / hyper.lengthScale.transpose().array();
    const Eigen::MatrixXd Z = scaled(inducing, Eigen::all);
    Eigen::MatrixXd outer = covariance(Z, Z, hyper.signalSd);
    outer.diagonal().array() += kJitter * hyper.signalSd * hyper.signalSd;
    factorise(outer);

    // V = L⁻¹ K_mn / σ_n, so that A = L (1 + V Vᵀ) Lᵀ is well conditioned.
    Eigen::MatrixXd V = covariance(Z, scaled, hyper.signalSd) / hyper.noiseSd;
    solveLower(outer, V);
    Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(Z.rows(), Z.rows());
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, size(V.rows()), size(V.cols()), 1.0,
                V.data(), size(V.rows()), 1.0, inner.data(), size(V.rows()));
    factorise(inner);
    solveLower(inner, V);

    const Eigen::VectorXd c = V * y / hyper.noiseSd;
    const Eigen::ArrayXd fit = hyper.noiseSd * (V.transpose() * c).array();
    const Eigen::ArrayXd hat = V.colwise().squaredNorm().transpose().array();
    ProjectedProcess process;
    process.leaveOneOut = (y.array() - fit) / (1.0 - hat).max(1e-9);
    process.weights = inner.triangularView<Eigen::Lower>().transpose().solve(c);
    outer.triangularView<Eigen::Lower>().transpose().solveInPlace(process.weights);
    return process;
}

}  // namespace terratact
