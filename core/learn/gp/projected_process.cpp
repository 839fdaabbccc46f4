#include "core/learn/gp/projected_process.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/learn/gp/cholesky.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/kernels/blas.h"
#include "core/learn/kernels/blas_size.h"
#include "core/learn/kernels/covariance_block.h"

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

/// Returns k(A, B).
Eigen::MatrixXd covariance(const ScaledRows& A, const Eigen::MatrixXd& B, double signalSd,
                           const Poll& poll)
{
    Eigen::MatrixXd K(A.X.rows(), B.rows());
    PolledWork work(poll);
    for (Eigen::Index b = 0; b < B.rows(); ++b) {
        K.col(b) = covarianceColumn(A, B.row(b), signalSd * signalSd);
        work.done(A.X.size());
    }
    return K;
}

/// Writes the Cholesky factor into the lower triangle, in place. Returns the reciprocal condition
/// number.
double factorise(Eigen::MatrixXd& K)
{
    const int n = blasSize(K.rows());
    const double norm = blas(LAPACKE_dlansy, LAPACK_COL_MAJOR, '1', 'L', n, K.data(), n);
    double rcond = 0.0;
    if (blas(LAPACKE_dpotrf, LAPACK_COL_MAJOR, 'L', n, K.data(), n) == 0)
        blas(LAPACKE_dpocon, LAPACK_COL_MAJOR, 'L', n, K.data(), n, norm, &rcond);
    if (!(rcond >= kMinRcond))
        throw std::invalid_argument(
            fmt::format("projected process: a covariance of {} inducing rows is singular "
                        "(reciprocal condition number below {:.0e})",
                        n, kMinRcond));
    return rcond;
}

/// Calls work(first, count) for columns of B; each: multiplications per column.
template <class Work>
void forColumns(const Eigen::MatrixXd& B, Eigen::Index each, const Poll& poll, Work work)
{
    const Eigen::Index step = linesAtOnce(each);
    for (Eigen::Index first = 0; first < B.cols(); first += step) {
        callPoll(poll);
        work(first, std::min(step, B.cols() - first));
    }
}

/// B := L⁻¹ B.
void solveLower(const Eigen::MatrixXd& L, Eigen::MatrixXd& B, const Poll& poll)
{
    forColumns(B, L.size() / 2, poll, [&](Eigen::Index first, Eigen::Index count) {
        blas(cblas_dtrsm, CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit,
             blasSize(B.rows()), blasSize(count), 1.0, L.data(), blasSize(L.rows()), &B(0, first),
             blasSize(B.rows()));
    });
}

/// Returns 1 + V Vᵀ, lower triangle.
Eigen::MatrixXd onePlusGram(const Eigen::MatrixXd& V, const Poll& poll)
{
    const int m = blasSize(V.rows());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Identity(m, m);
    forColumns(V, gram.size() / 2, poll, [&](Eigen::Index first, Eigen::Index count) {
        blas(cblas_dsyrk, CblasColMajor, CblasLower, CblasNoTrans, m, blasSize(count), 1.0,
             &V(0, first), m, 1.0, gram.data(), m);
    });
    return gram;
}

/// Computes the residuals of rows that share a place. V: H = Vᵀ V; misfit: y − mean(x).
void leaveOutPlaces(Eigen::VectorXd& leaveOneOut, const Eigen::MatrixXd& V,
                    const Eigen::VectorXd& misfit, const std::vector<int>& places, const Poll& poll)
{
    std::map<int, std::vector<int>> rowsOfPlace;
    for (std::size_t u = 0; u < places.size(); ++u)
        rowsOfPlace[places[u]].push_back(static_cast<int>(u));
    for (const auto& [place, rows] : rowsOfPlace) {
        if (rows.size() < 2) continue;
        callPoll(poll);
        const Eigen::MatrixXd own = V(Eigen::all, rows);
        Eigen::MatrixXd freedom = -own.transpose() * own;
        freedom.diagonal().array() += 1.0 + kMinFreedom;
        const Eigen::VectorXd ownMisfit = misfit(rows);
        const Eigen::VectorXd residuals = freedom.ldlt().solve(ownMisfit);
        leaveOneOut(rows) = residuals;
    }
}

}  // namespace

double ProjectedProcess::errorBound() const
{
    return errorBoundAt(rcond);
}

ProjectedProcess projectProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                const std::vector<int>& inducing, const Hyperparameters& hyper,
                                const Poll& poll, const std::vector<int>& places,
                                const Eigen::VectorXd& rowVariance)
{
    check(X, y, inducing, hyper);
    requireRowVariance(rowVariance, y.size());
    // Rows with another noise are scaled to σ_n.
    Eigen::ArrayXd scale = Eigen::ArrayXd::Ones(rowVariance.size());
    if (rowVariance.size() > 0)
        scale = hyper.noiseSd / (hyper.noiseSd * hyper.noiseSd + rowVariance.array()).sqrt();
    const auto isScaled = [&scale] { return scale.size() > 0; };
    if (!places.empty() && std::ssize(places) != X.rows())
        throw std::invalid_argument("projected process: needs one place per row");
    const ScaledRows Z = inLengthScales(X, hyper).some(inducing);
    Eigen::MatrixXd outer = covariance(Z, Z.X, hyper.signalSd, poll);
    outer.diagonal().array() += kProjectionJitter * hyper.signalSd * hyper.signalSd;
    ProjectedProcess process;
    process.rcond = factorise(outer);

    // V = L⁻¹ K_mn / σ_n, so that A = L (1 + V Vᵀ) Lᵀ is well conditioned.
    Eigen::MatrixXd V = covariance(Z, X, hyper.signalSd, poll);
    const Eigen::Index onePass =
        V.rows() * static_cast<Eigen::Index>(kMaxMultiplications / kMaxRead);
    forColumns(V, onePass, poll, [&](Eigen::Index first, Eigen::Index count) {
        V.middleCols(first, count) /= hyper.noiseSd;
    });
    if (isScaled()) V.array().rowwise() *= scale.transpose();
    solveLower(outer, V, poll);
    Eigen::MatrixXd inner = onePlusGram(V, poll);
    process.rcond = std::min(process.rcond, factorise(inner));
    solveLower(inner, V, poll);

    Eigen::VectorXd own = y;
    if (isScaled()) own.array() *= scale;
    Eigen::VectorXd c = Eigen::VectorXd::Zero(V.rows());
    forColumns(V, onePass, poll, [&](Eigen::Index first, Eigen::Index count) {
        c += V.middleCols(first, count) * own.segment(first, count);
    });
    c /= hyper.noiseSd;
    Eigen::ArrayXd fit(V.cols()), hat(V.cols());
    forColumns(V, onePass, poll, [&](Eigen::Index first, Eigen::Index count) {
        const auto some = V.middleCols(first, count);
        fit.segment(first, count) = hyper.noiseSd * (some.transpose() * c).array();
        hat.segment(first, count) = some.colwise().squaredNorm().transpose().array();
    });
    process.leaveOneOut = (own.array() - fit) / (1.0 - hat).max(kMinFreedom);
    leaveOutPlaces(process.leaveOneOut, V, (own.array() - fit).matrix(), places, poll);
    if (isScaled()) process.leaveOneOut.array() /= scale;
    process.weights = inner.triangularView<Eigen::Lower>().transpose().solve(c);
    outer.triangularView<Eigen::Lower>().transpose().solveInPlace(process.weights);
    return process;
}

}  // namespace terratact
