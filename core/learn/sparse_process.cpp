#include "core/learn/sparse_process.h"

#include <cblas.h>
#include <fmt/format.h>
#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/learn/cholesky.h"
#include "core/learn/covariance_column.h"
#include "core/learn/gaussian_process.h"

namespace terratact {

namespace {

constexpr double kLeastPivot = 1e-8;   // of σ_f²: a row that adds less is not worth inducing
constexpr double kLeastLambda = 1e-9;  // of σ_f²
constexpr int kCandidatesPerRow = 4;

int size(Eigen::Index n)
{
    return static_cast<int>(n);
}

/// Rows of a product with m² multiplications each that lie between two polls.
Eigen::Index rowsAtOnce(Eigen::Index m)
{
    const auto each = static_cast<double>(m * m);
    return std::max<Eigen::Index>(1, static_cast<Eigen::Index>(kMostMultiplications / each));
}

std::vector<int> evenlySpread(Eigen::Index rows, Eigen::Index wanted)
{
    const Eigen::Index count = std::min(rows, wanted);
    std::vector<int> chosen;
    for (Eigen::Index k = 0; k < count; ++k) chosen.push_back(size(k * rows / count));
    return chosen;
}

/// Inducing rows and the factor of their covariance, K_mm = L Lᵀ, with its reciprocal condition number.
struct Inducing {
    std::vector<int> rows;
    Eigen::MatrixXd L;
    double rcond;
};

/// Of K = L Lᵀ, whose columns are covariances of the rows of Z.
double conditionOf(const Eigen::MatrixXd& L, const Eigen::MatrixXd& Z, double signal2,
                   const Poll& poll)
{
    double norm = 0.0;
    for (Eigen::Index k = 0; k < Z.rows(); ++k) {
        callPoll(poll);
        norm = std::max(norm, covarianceColumn(Z, Z.row(k), signal2).sum());
    }
    return reciprocalCondition(L.transpose(), norm, poll);
}

Inducing chooseInducing(const Eigen::MatrixXd& scaled, int count, double signal2, const Poll& poll)
{
    const std::vector<int> candidates =
        evenlySpread(scaled.rows(), kCandidatesPerRow * static_cast<Eigen::Index>(count));
    const Eigen::MatrixXd X = scaled(candidates, Eigen::all);
    const Eigen::Index most = std::min<Eigen::Index>(count, X.rows());
    Eigen::MatrixXd V(X.rows(), most);  // of the pivoted Cholesky k(X, X) ≈ V Vᵀ
    Eigen::VectorXd variance = Eigen::VectorXd::Constant(X.rows(), signal2);
    std::vector<int> pivots;
    for (Eigen::Index j = 0; j < most; ++j) {
        Eigen::Index p = 0;
        callPoll(poll);
        if (!(variance.maxCoeff(&p) > kLeastPivot * signal2)) break;
        V.col(j) = covarianceColumn(X, X.row(p), signal2);
        const Eigen::VectorXd ofPivot = V.row(p).head(j);
        cblas_dgemv(CblasColMajor, CblasNoTrans, size(X.rows()), size(j), -1.0, V.data(),
                    size(X.rows()), ofPivot.data(), 1, 1.0, V.col(j).data(), 1);
        V.col(j) /= std::sqrt(variance[p]);
        variance -= V.col(j).cwiseAbs2();
        variance[p] = 0.0;
        pivots.push_back(size(p));
    }
    const auto m = static_cast<Eigen::Index>(pivots.size());
    Inducing inducing{{}, V(pivots, Eigen::seqN(0, m)).triangularView<Eigen::Lower>(), 0.0};
    inducing.rcond = conditionOf(inducing.L, X(pivots, Eigen::all), signal2, poll);
    for (const int p : pivots) inducing.rows.push_back(candidates[static_cast<std::size_t>(p)]);
    return inducing;
}

/// A := A T⁻¹ for T = L or Lᵀ, by rows.
void divide(Eigen::MatrixXd& A, const Eigen::MatrixXd& L, CBLAS_TRANSPOSE transpose,
            const Poll& poll)
{
    const Eigen::Index step = rowsAtOnce(L.rows());
    for (Eigen::Index first = 0; first < A.rows(); first += step) {
        callPoll(poll);
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, transpose, CblasNonUnit,
                    size(std::min(step, A.rows() - first)), size(L.rows()), 1.0, L.data(),
                    size(L.rows()), &A(first, 0), size(A.rows()));
    }
}

/// V = L⁻¹ K_mn, transposed: n × m.
Eigen::MatrixXd projection(const Eigen::MatrixXd& scaled, const Inducing& inducing, double signal2,
                           const Poll& poll)
{
    const Eigen::Index m = inducing.L.rows();
    Eigen::MatrixXd V(scaled.rows(), m);
    for (Eigen::Index k = 0; k < m; ++k) {
        callPoll(poll);
        V.col(k) = covarianceColumn(scaled, scaled.row(inducing.rows[static_cast<std::size_t>(k)]),
                                    signal2);
    }
    divide(V, inducing.L, CblasTrans, poll);
    return V;
}

/// 1 + Vᵀ V, upper triangle.
Eigen::MatrixXd onePlusGram(const Eigen::MatrixXd& V, const Poll& poll)
{
    const int m = size(V.cols());
    Eigen::MatrixXd B = Eigen::MatrixXd::Identity(m, m);
    const Eigen::Index step = rowsAtOnce(m);
    for (Eigen::Index first = 0; first < V.rows(); first += step) {
        callPoll(poll);
        cblas_dsyrk(CblasColMajor, CblasUpper, CblasTrans, m,
                    size(std::min(step, V.rows() - first)), 1.0, &V(first, 0), size(V.rows()), 1.0,
                    B.data(), m);
    }
    return B;
}

/// Upper Cholesky factor in place, zeros below.
void factorise(Eigen::MatrixXd& A, const Poll& poll)
{
    if (!choleskyUpper(A, poll))
        throw std::invalid_argument(
            "sparse Gaussian process: a covariance is not positive definite");
    A.triangularView<Eigen::StrictlyLower>().setZero();
}

/// U Uᵀ for an upper triangle U.
Eigen::MatrixXd gramOfRows(const Eigen::MatrixXd& U, const Poll& poll)
{
    Eigen::MatrixXd product = U.transpose();
    const Eigen::Index step = rowsAtOnce(U.rows());
    for (Eigen::Index first = 0; first < U.rows(); first += step) {
        callPoll(poll);
        cblas_dtrmm(CblasColMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit,
                    size(U.rows()), size(std::min(step, U.rows() - first)), 1.0, U.data(),
                    size(U.rows()), &product(0, first), size(U.rows()));
    }
    return product;
}

/// Lower C with Cᵀ C = 1 − B⁻¹, from R of B = Rᵀ R.
Eigen::MatrixXd factorOfGain(Eigen::MatrixXd R, const Poll& poll)
{
    constexpr double kRounding = 1e-13;
    invertUpper(R, poll);
    Eigen::MatrixXd gain = -gramOfRows(R, poll).reverse();
    gain.diagonal().array() += 1.0 + kRounding;
    factorise(gain, poll);  // in reversed order: the factor of what was, lower times upper
    return gain.reverse();
}

}  // namespace

SparseProcess sparseProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, int count,
                            const Hyperparameters& hyper, const Poll& poll)
{
    requireTrainable(X, y, hyper);
    if (count < 1) throw std::invalid_argument("sparse Gaussian process: no inducing rows");
    const double signal2 = hyper.signalSd * hyper.signalSd;
    const double noise = hyper.noiseSd * hyper.noiseSd;
    if (!(signal2 >= std::numeric_limits<double>::min()) || !std::isfinite(signal2 + noise))
        throw std::invalid_argument(
            "sparse Gaussian process: the signal's variance underflows, or a variance overflows");
    const double noise2 = std::max(noise, kLeastLambda * signal2);
    const Eigen::MatrixXd scaled = X.array().rowwise() / hyper.lengthScale.transpose().array();
    if (!scaled.allFinite())
        throw std::invalid_argument("Gaussian process: an input overflows in length scales");
    const Inducing inducing = chooseInducing(scaled, count, signal2, poll);
    Eigen::MatrixXd V = projection(scaled, inducing, signal2, poll);

    // A = L B Lᵀ with B = 1 + V Λ⁻¹ Vᵀ, well conditioned.
    const Eigen::ArrayXd lambda = (signal2 - V.rowwise().squaredNorm().array()).max(0.0) + noise2;
    const Eigen::ArrayXd scale = lambda.rsqrt();
    V.array().colwise() *= scale;
    const Eigen::VectorXd projected = V.transpose() * (y.array() * scale).matrix();
    const int m = size(V.cols());
    Eigen::MatrixXd R = onePlusGram(V, poll);
    const double norm = symmetricNorm(R, poll);
    factorise(R, poll);

    SparseProcess sparse{inducing.rows, projected, {}, (noise2 - noise) / (signal2 + noise)};
    sparse.rcond = std::min({inducing.rcond, reciprocalCondition(R, norm, poll),
                             lambda.minCoeff() / (signal2 + noise)});
    if (!(sparse.rcond >= kLeastRcond))
        throw std::invalid_argument(
            fmt::format("sparse Gaussian process: a covariance of {} inducing rows is singular "
                        "(reciprocal condition number below {:.0e})",
                        m, kLeastRcond));
    LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'U', m, 1, R.data(), m, sparse.weights.data(), m);
    cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, m, inducing.L.data(), m,
                sparse.weights.data(), 1);
    sparse.F = factorOfGain(std::move(R), poll);
    divide(sparse.F, inducing.L, CblasNoTrans, poll);
    return sparse;
}

}  // namespace terratact
