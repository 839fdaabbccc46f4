#include "core/learn/gp/sparse_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/learn/gp/cholesky.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/inducing_rows.h"
#include "core/learn/kernels/blas.h"
#include "core/learn/kernels/blas_size.h"
#include "core/learn/kernels/covariance_block.h"

namespace terratact {

namespace {

/// Least gain of an inducing row, as a share of σ_f². If rows with more gain make K_mm singular,
/// the next value applies.
constexpr double kMinPivots[] = {1e-8, 1e-7, 1e-6};
constexpr double kMinLambda = 1e-9;  // share of σ_f²
constexpr int kCandidatesPerRow = 4;
constexpr long kWorkOfACovariance = 4;  // units of PolledWork
constexpr int kColumnsAtOnce = 64;  // columns of a product at once: enough to read a factor seldom
constexpr double kShare = 0.3;      // share of the largest variance, for rows of a reduction
constexpr double kMaxReduced = 0.92;  // share of the rows: more would save little
constexpr int kPowerSteps = 32;       // enough for an eigenvalue that is at most a tenth too low
constexpr double kPowerLow = 1.1;

std::vector<int> evenlySpread(Eigen::Index rows, Eigen::Index wanted)
{
    const Eigen::Index count = std::min(rows, wanted);
    std::vector<int> chosen;
    chosen.reserve(static_cast<std::size_t>(count));
    for (Eigen::Index k = 0; k < count; ++k) chosen.push_back(blasSize(k * rows / count));
    return chosen;
}

/// Inducing rows and the factor of their covariance, K_mm = L Lᵀ, with its reciprocal condition
/// number. V = L⁻¹ K_mn is stored transposed: n × m.
struct Inducing {
    std::vector<int> rows;
    Eigen::MatrixXd L;
    double rcond = 0.0;
    Eigen::MatrixXd V{};
};

/// Returns the reciprocal condition number of K = L Lᵀ, whose columns are covariances of the rows
/// of Z.
double conditionOf(const Eigen::MatrixXd& L, const ScaledRows& Z, double signal2, const Poll& poll)
{
    double norm = 0.0;
    for (Eigen::Index k = 0; k < Z.X.rows(); ++k) {
        callPoll(poll);
        norm = std::max(norm, covarianceColumn(Z, Z.X.row(k), signal2).sum());
    }
    return reciprocalCondition(L.transpose(), norm, poll);
}

/// Returns V = L⁻¹ K_mn, transposed, for rows that were chosen among some rows of X.
Eigen::MatrixXd projection(const ScaledRows& X, const std::vector<int>& rows,
                           const Eigen::MatrixXd& L, double signal2, const Poll& poll)
{
    const Eigen::Index m = L.rows();
    Eigen::MatrixXd V(X.X.rows(), m);
    for (Eigen::Index k = 0; k < m; ++k) {
        callPoll(poll);
        V.col(k) = covarianceColumn(X, X.X.row(rows[static_cast<std::size_t>(k)]), signal2);
    }
    const Eigen::Index step = linesAtOnce(m * m);
    for (Eigen::Index first = 0; first < V.rows(); first += step) {
        callPoll(poll);
        blas(cblas_dtrsm, CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit,
             blasSize(std::min(step, V.rows() - first)), blasSize(m), 1.0, L.data(), blasSize(m),
             &V(first, 0), blasSize(V.rows()));
    }
    return V;
}

/// Chooses up to `count` of the candidate rows, as many as keep K_mm well conditioned.
Inducing chooseAmong(const ScaledRows& X, const std::vector<int>& candidates, int count,
                     double signal2, const Poll& poll)
{
    for (const double least : kMinPivots) {
        InducingRows among = chooseInducingRows(
            X.some(candidates), signal2, {.most = count, .leastVariance = least * signal2}, poll);
        Inducing inducing{{}, factorOf(among, poll)};
        for (const int p : among.rows)
            inducing.rows.push_back(candidates[static_cast<std::size_t>(p)]);
        inducing.rcond = conditionOf(inducing.L, X.some(inducing.rows), signal2, poll);
        if (!(inducing.rcond >= kMinRcond)) continue;
        inducing.V = among.V.rows() == X.X.rows()  // the candidates are then all rows, in order
                       ? std::move(among.V)
                       : projection(X, inducing.rows, inducing.L, signal2, poll);
        return inducing;
    }
    throw std::invalid_argument(
        fmt::format("sparse Gaussian process: the covariance of its inducing rows is singular "
                    "(reciprocal condition number below {:.0e})",
                    kMinRcond));
}

/// Calls work(j) for every column of `each` numbers.
template <class Work>
void forColumns(Eigen::Index columns, Eigen::Index each, const Poll& poll, Work work)
{
    PolledWork polled(poll);
    for (Eigen::Index j = 0; j < columns; ++j) {
        work(j);
        polled.done(each);
    }
}

/// Returns 1 + Vᵀ V, upper triangle.
Eigen::MatrixXd onePlusInnerGram(const Eigen::MatrixXd& V, const Poll& poll)
{
    const int n = blasSize(V.rows());
    const int m = blasSize(V.cols());
    Eigen::MatrixXd B(m, m);
    const int step = blasSize(linesAtOnce(static_cast<Eigen::Index>(m) * kColumnsAtOnce));
    for (int first = 0; first < m; first += kColumnsAtOnce) {
        const int columns = std::min(kColumnsAtOnce, m - first);
        for (int row = 0; row < n; row += step) {
            callPoll(poll);
            blas(cblas_dgemm, CblasColMajor, CblasTrans, CblasNoTrans, first + columns, columns,
                 std::min(step, n - row), 1.0, &V(row, 0), n, &V(row, first), n,
                 row == 0 ? 0.0 : 1.0, &B(0, first), m);
        }
    }
    B.diagonal().array() += 1.0;
    return B;
}

/// Writes the upper Cholesky factor in place, zeros below. Returns false if A is not positive
/// definite.
bool factorise(Eigen::MatrixXd& A, const Poll& poll)
{
    if (!choleskyUpper(A, poll)) return false;
    forColumns(A.cols(), A.rows(), poll,
               [&A](Eigen::Index j) { A.col(j).tail(A.rows() - j - 1).setZero(); });
    return true;
}

/// Returns U Uᵀ for an upper triangle U with zeros below: upper triangle.
Eigen::MatrixXd gramOfRows(const Eigen::MatrixXd& U, const Poll& poll)
{
    const int m = blasSize(U.rows());
    Eigen::MatrixXd product(m, m);
    const int step = blasSize(std::min<Eigen::Index>(kColumnsAtOnce, linesAtOnce(U.size() / 4)));
    for (int first = 0; first < m; first += step) {
        const int columns = std::min(step, m - first);
        callPoll(poll);
        blas(cblas_dgemm, CblasColMajor, CblasNoTrans, CblasTrans, first + columns, columns,
             m - first, 1.0, &U(0, first), m, &U(first, first), m, 0.0, &product(0, first), m);
    }
    return product;
}

/// Returns the lower triangle C with Cᵀ C = 1 − B⁻¹, from R of B = Rᵀ R. Returns nothing if
/// rounding dominates a direction.
std::optional<Eigen::MatrixXd> factorOfGain(Eigen::MatrixXd R, const Poll& poll)
{
    constexpr double kRounding = 1e-13;
    invertUpper(R, poll);
    const Eigen::Index m = R.cols();
    Eigen::MatrixXd gain(m, m);  // rows and columns in reverse order
    {
        const Eigen::MatrixXd inverse = gramOfRows(R, poll);
        forColumns(m, m, poll, [&](Eigen::Index j) {
            gain.col(j).head(j + 1) = -inverse.row(m - 1 - j).tail(j + 1).reverse().transpose();
        });
    }
    gain.diagonal().array() += 1.0 + kRounding;
    // the factor is lower times upper of the original order
    if (!factorise(gain, poll)) return std::nullopt;
    forColumns(m, m, poll, [&](Eigen::Index j) { R.col(j) = gain.col(m - 1 - j).reverse(); });
    return R;
}

/// C := C L⁻¹ for lower triangles.
void divide(Eigen::MatrixXd& C, const Eigen::MatrixXd& L, const Poll& poll)
{
    const Eigen::Index m = C.rows();
    const Eigen::Index step = std::min<Eigen::Index>(kColumnsAtOnce, linesAtOnce(m * m / 2));
    for (Eigen::Index first = 0; first < m; first += step) {
        const Eigen::Index rows = std::min(step, m - first);
        callPoll(poll);
        blas(cblas_dtrsm, CblasColMajor, CblasRight, CblasLower, CblasNoTrans, CblasNonUnit,
             blasSize(rows), blasSize(first + rows), 1.0, L.data(), blasSize(m), &C(first, 0),
             blasSize(m));
    }
}

/// Result of the inducing rows: Λ, and A = L B Lᵀ with B = 1 + V Λ⁻¹ Vᵀ = Rᵀ R, well conditioned.
struct Explained {
    Eigen::ArrayXd lambda;
    Eigen::MatrixXd R;
    double rcond;  // of B; 0 if it is not positive definite
};

/// Computes Explained. V: divided by √Λ on return.
Explained explain(Eigen::MatrixXd& V, double signal2, double noise2, const Poll& poll,
                  const Eigen::VectorXd& rowVariance = {})
{
    const Eigen::Index n = V.rows();
    Eigen::ArrayXd lambda = Eigen::ArrayXd::Constant(n, signal2);
    forColumns(V.cols(), n, poll, [&](Eigen::Index k) { lambda -= V.col(k).array().square(); });
    Explained explained{lambda.max(0.0) + noise2, {}, 0.0};
    if (rowVariance.size() > 0) explained.lambda += rowVariance.array();
    const Eigen::ArrayXd scale = explained.lambda.rsqrt();
    forColumns(V.cols(), n, poll, [&](Eigen::Index k) { V.col(k).array() *= scale; });
    explained.R = onePlusInnerGram(V, poll);
    const double norm = symmetricNorm(explained.R, poll);
    if (factorise(explained.R, poll))
        explained.rcond = reciprocalCondition(explained.R, norm, poll);
    return explained;
}

/// Returns k(O, O) − V_O V_Oᵀ for the remaining rows O: the covariance that the chosen rows leave.
Eigen::MatrixXd leftOf(const ScaledRows& X, const InducingRows& chosen, double signal2,
                       const Poll& poll)
{
    const std::vector<int> others = rowsNotIn(chosen.rows, X.X.rows());
    const ScaledRows O = X.some(others);
    const int n = blasSize(O.X.rows());
    const int m = blasSize(chosen.V.cols());
    Eigen::MatrixXd V(n, m);
    forColumns(m, n, poll, [&](Eigen::Index j) { V.col(j) = chosen.V.col(j)(others); });
    Eigen::MatrixXd left(n, n);
    PolledWork work(poll);
    const int step = blasSize(linesAtOnce(static_cast<Eigen::Index>(m) * kColumnsAtOnce));
    for (int first = 0; first < n; first += kColumnsAtOnce) {
        const int columns = std::min(kColumnsAtOnce, n - first);
        for (int j = first; j < first + columns; ++j) {
            left.col(j) = covarianceColumn(O, O.X.row(j), signal2);
            work.done(kWorkOfACovariance * n);
        }
        for (int row = 0; row < n; row += step) {
            callPoll(poll);
            blas(cblas_dgemm, CblasColMajor, CblasNoTrans, CblasTrans, std::min(step, n - row),
                 columns, m, -1.0, &V(row, 0), n, &V(first, 0), n, 1.0, &left(row, first), n);
        }
    }
    return left;
}

/// Returns the largest eigenvalue of a positive semidefinite matrix by the power method, from a
/// start that prefers no row.
double largestEigenvalue(const Eigen::MatrixXd& A, const Poll& poll)
{
    Eigen::VectorXd x(A.cols());
    std::uint64_t state = 1;
    for (double& value : x) {  // signs of a linear congruential generator
        state = state * 6364136223846793005U + 1442695040888963407U;
        value = state >> 63U ? 1.0 : -1.0;
    }
    double largest = 0.0;
    for (int step = 0; step < kPowerSteps && x.norm() > 0.0; ++step) {
        x.normalize();
        Eigen::VectorXd next = Eigen::VectorXd::Zero(x.size());
        forColumns(A.cols(), A.rows(), poll, [&](Eigen::Index j) { next += x[j] * A.col(j); });
        largest = next.norm();
        x = std::move(next);
    }
    return largest;
}

/// Returns F of SparseProcess; nothing if factorOfGain returns nothing.
std::optional<Eigen::MatrixXd> explainedFactor(Explained explained, const Eigen::MatrixXd& L,
                                               const Poll& poll)
{
    std::optional<Eigen::MatrixXd> F = factorOfGain(std::move(explained.R), poll);
    if (F) divide(*F, L, poll);
    return F;
}

}  // namespace

SparseProcess sparseProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, int count,
                            const Hyperparameters& hyper, const Poll& poll,
                            const Eigen::VectorXd& rowVariance)
{
    requireTrainable(X, y, hyper);
    requireRowVariance(rowVariance, y.size());
    if (count < 1) throw std::invalid_argument("sparse Gaussian process: no inducing rows");
    const double signal2 = hyper.signalSd * hyper.signalSd;
    const double noise = hyper.noiseSd * hyper.noiseSd;
    if (!(signal2 >= std::numeric_limits<double>::min()) || !std::isfinite(signal2 + noise))
        throw std::invalid_argument(
            "sparse Gaussian process: the signal's variance underflows, or a variance overflows");
    const double noise2 = std::max(noise, kMinLambda * signal2);
    const ScaledRows scaled = inLengthScales(X, hyper);
    Inducing inducing = chooseAmong(
        scaled, evenlySpread(X.rows(), kCandidatesPerRow * static_cast<Eigen::Index>(count)), count,
        signal2, poll);
    Explained explained = explain(inducing.V, signal2, noise2, poll, rowVariance);
    SparseProcess sparse{inducing.rows,
                         inducing.V.transpose() * (y.array() * explained.lambda.rsqrt()).matrix(),
                         {},
                         (noise2 - noise) / (signal2 + noise)};
    sparse.rcond = std::min(
        {inducing.rcond, explained.rcond, explained.lambda.minCoeff() / (signal2 + noise)});
    const int m = blasSize(inducing.L.rows());
    if (!(sparse.rcond >= kMinRcond))
        throw std::invalid_argument(fmt::format(
            "sparse Gaussian process: a covariance through {} inducing rows is singular "
            "(reciprocal condition number below {:.0e})",
            m, kMinRcond));
    blas(LAPACKE_dpotrs, LAPACK_COL_MAJOR, 'U', m, 1, explained.R.data(), m, sparse.weights.data(),
         m);
    blas(cblas_dtrsv, CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, m, inducing.L.data(), m,
         sparse.weights.data(), 1);
    std::optional<Eigen::MatrixXd> F = explainedFactor(std::move(explained), inducing.L, poll);
    if (!F)
        throw std::invalid_argument(
            "sparse Gaussian process: a covariance is not positive definite");
    sparse.F = std::move(*F);
    return sparse;
}

std::optional<ReducedVariance> reducedVariance(const Eigen::MatrixXd& X,
                                               const Hyperparameters& hyper, const Poll& poll)
{
    const double signal2 = hyper.signalSd * hyper.signalSd;
    const double noise2 = hyper.noiseSd * hyper.noiseSd;
    const double unexplained = kUnexplainedOfNoise * noise2;
    if (!(unexplained > kMinPivots[0] * signal2) || !std::isnormal(signal2)) return std::nullopt;
    const auto most = static_cast<Eigen::Index>(kMaxReduced * static_cast<double>(X.rows()));
    const ScaledRows scaled = inLengthScales(X, hyper);
    InducingRows chosen = chooseInducingRows(scaled, signal2,
                                             {.most = most,
                                              .leastVariance = unexplained,
                                              .share = kShare,
                                              .mostHalfway = std::sqrt(signal2 * unexplained)},
                                             poll);
    if (chosen.left > unexplained || chosen.rows.empty()) return std::nullopt;
    const double together = largestEigenvalue(leftOf(scaled, chosen, signal2, poll), poll);
    if (!(kPowerLow * together <= kLeftTogether * noise2)) return std::nullopt;
    const Eigen::MatrixXd L = factorOf(chosen, poll);
    Explained explained = explain(chosen.V, signal2, noise2, poll);
    if (!(explained.rcond >= kMinRcond)) return std::nullopt;
    chosen.V.resize(0, 0);
    std::optional<Eigen::MatrixXd> F = explainedFactor(std::move(explained), L, poll);
    if (!F) return std::nullopt;
    return ReducedVariance{std::move(chosen.rows), std::move(*F)};
}

}  // namespace terratact
