#include "core/learn/projected_process.h"

#include <cblas.h>
#include <fmt/format.h>
#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learn/blas_size.h"
#include "core/learn/covariance_column.h"
#include "core/learn/gaussian_process.h"

namespace terratact {

namespace {

void check(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const std::vector<int>& inducing,
           const Hyperparameters& hyper)
{
    if (X.rows() != y.size() || X.cols() != hyper.lengthScale.size() || inducing.empty())
        throw std::invalid_argument("projected process: sizes disagree or no inducing row");
    if (!X.allFinite() || !y.allFinite() || !hyper.lengthScale.allFinite()
        || !(hyper.lengthScale.array() > 0.0).all())
        throw std::invalid_argument(
            "projected process: numbers must be finite and length scales positive");
    if (!(hyper.noiseSd > 0.0) || !(hyper.signalSd > 0.0) || !std::isfinite(hyper.noiseSd)
        || !std::isfinite(hyper.signalSd))
        throw std::invalid_argument("projected process: σ_f and σ_n must be positive");
    for (const int row : inducing)
        if (row < 0 || row >= X.rows())
            throw std::invalid_argument("projected process: an inducing row does not exist");
}

/// k(A, B) for rows in length scales.
Eigen::MatrixXd covariance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double signalSd)
{
    Eigen::MatrixXd K(A.rows(), B.rows());
    for (Eigen::Index b = 0; b < B.rows(); ++b)
        K.col(b) = covarianceColumn(A, B.row(b), signalSd * signalSd);
    return K;
}

/// Cholesky factor in the lower triangle, in place.  The reciprocal condition number.
double factorise(Eigen::MatrixXd& K)
{
    const int n = blasSize(K.rows());
    const double norm = LAPACKE_dlansy(LAPACK_COL_MAJOR, '1', 'L', n, K.data(), n);
    double rcond = 0.0;
    if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, K.data(), n) == 0)
        LAPACKE_dpocon(LAPACK_COL_MAJOR, 'L', n, K.data(), n, norm, &rcond);
    if (!(rcond >= kLeastRcond))
        throw std::invalid_argument(
            fmt::format("projected process: a covariance of {} inducing rows is singular "
                        "(reciprocal condition number below {:.0e})",
                        n, kLeastRcond));
    return rcond;
}

/// B := L⁻¹ B.
void solveLower(const Eigen::MatrixXd& L, Eigen::MatrixXd& B)
{
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit,
                blasSize(B.rows()), blasSize(B.cols()), 1.0, L.data(), blasSize(L.rows()), B.data(),
                blasSize(B.rows()));
}

}  // namespace

double ProjectedProcess::errorBound() const
{
    return errorBoundAt(rcond);
}

ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper)
{
    check(X, y, inducing, hyper);
    const Eigen::MatrixXd scaled = X.array().rowwise() / hyper.lengthScale.transpose().array();
    if (!scaled.allFinite())
        throw std::invalid_argument("projected process: an input overflows in length scales");
    const Eigen::MatrixXd Z = scaled(inducing, Eigen::all);
    Eigen::MatrixXd outer = covariance(Z, Z, hyper.signalSd);
    outer.diagonal().array() += kProjectionJitter * hyper.signalSd * hyper.signalSd;
    ProjectedProcess process;
    process.rcond = factorise(outer);

    // V = L⁻¹ K_mn / σ_n, so that A = L (1 + V Vᵀ) Lᵀ is well conditioned.
    Eigen::MatrixXd V = covariance(Z, scaled, hyper.signalSd) / hyper.noiseSd;
    solveLower(outer, V);
    Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(Z.rows(), Z.rows());
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, blasSize(V.rows()), blasSize(V.cols()),
                1.0, V.data(), blasSize(V.rows()), 1.0, inner.data(), blasSize(V.rows()));
    process.rcond = std::min(process.rcond, factorise(inner));
    solveLower(inner, V);

    const Eigen::VectorXd c = V * y / hyper.noiseSd;
    const Eigen::ArrayXd fit = hyper.noiseSd * (V.transpose() * c).array();
    const Eigen::ArrayXd hat = V.colwise().squaredNorm().transpose().array();
    process.leaveOneOut = (y.array() - fit) / (1.0 - hat).max(kLeastFreedom);
    process.weights = inner.triangularView<Eigen::Lower>().transpose().solve(c);
    outer.triangularView<Eigen::Lower>().transpose().solveInPlace(process.weights);
    return process;
}

}  // namespace terratact
