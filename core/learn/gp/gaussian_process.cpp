#include "core/learn/gp/gaussian_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/learn/gp/inducing_rows.h"
#include "core/learn/gp/scene_conditional.h"
#include "core/learn/gp/sparse_process.h"
#include "core/learn/kernels/blas_size.h"
#include "core/learn/kernels/covariance_block.h"
#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/huge_pages.h"

namespace terratact {

namespace {

/// Returns the largest error of single precision at the probes: a small share of the least
/// variance, the noise.
double mostSingleError(const Hyperparameters& hyper)
{
    return 2e-3 * hyper.noiseSd * hyper.noiseSd;
}

/// Returns the signal part k(X, X), upper triangle, by blocks of columns; the lower triangle is not
/// set.
Eigen::MatrixXd signalCovariance(const Eigen::MatrixXd& X, const Hyperparameters& hyper,
                                 const Poll& poll)
{
    const int U = blasSize(X.rows());
    CovarianceBlock block(inLengthScales(X, hyper), hyper.signalSd * hyper.signalSd);
    Eigen::MatrixXd K(U, U);
    preferHugePages(K.data(), static_cast<std::size_t>(K.size()) * sizeof(double));
    std::vector<int> columns;
    for (int first = 0; first < U; first += kGroup) {
        callPoll(poll);
        columns.resize(static_cast<std::size_t>(std::min(kGroup, U - first)));
        std::iota(columns.begin(), columns.end(), first);
        // The rows before the block are the upper triangle of its columns.
        const double* covariances = block.with(columns, columns.back() + 1);
        for (const int c : columns)
            for (int u = 0; u <= c; ++u) K(u, c) = covariances[u * kGroup + c - first];
    }
    return K;
}

struct Factor {
    Eigen::MatrixXd R;  // upper triangle, K + jitter = Rᵀ R
    double jitter = 0.0, rcond = 0.0;
};

/// Returns K + jitter (σ_f² + σ_n²) I with the noise included, upper triangle.
Eigen::MatrixXd noisyCovariance(const Eigen::MatrixXd& X, const Hyperparameters& hyper,
                                const Eigen::VectorXd& rowVariance, double jitter, const Poll& poll)
{
    const double noise2 = hyper.noiseSd * hyper.noiseSd;
    const double prior = hyper.signalSd * hyper.signalSd + noise2;
    Eigen::MatrixXd K = signalCovariance(X, hyper, poll);
    K.diagonal().array() += noise2 + jitter * prior;
    if (rowVariance.size() > 0) K.diagonal() += rowVariance;
    return K;
}

/// Returns rcond 0 if the matrix is not positive definite.
Factor tryFactor(const Eigen::MatrixXd& X, const Hyperparameters& hyper,
                 const Eigen::VectorXd& rowVariance, double jitter, const Poll& poll)
{
    Factor factor{noisyCovariance(X, hyper, rowVariance, jitter, poll), jitter, 0.0};
    const double norm = symmetricNorm(factor.R, poll);
    if (choleskyUpper(factor.R, poll)) factor.rcond = reciprocalCondition(factor.R, norm, poll);
    return factor;
}

/// Factorises K with the least jitter that makes it well enough conditioned.
Factor factorWithJitter(const Eigen::MatrixXd& X, const Hyperparameters& hyper,
                        const Eigen::VectorXd& rowVariance, const Poll& poll)
{
    for (const double jitter : {0.0, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
        Factor factor = tryFactor(X, hyper, rowVariance, jitter, poll);
        if (factor.rcond >= kMinRcond) return factor;
    }
    throw std::invalid_argument(
        fmt::format("Gaussian process: the covariance of {} rows is singular (reciprocal condition "
                    "number below "
                    "{:.0e}) with every jitter up to 1e-6; signal sd {:.3g} m, noise sd {:.3g} m",
                    X.rows(), kMinRcond, hyper.signalSd, hyper.noiseSd));
}

/// Returns covariances with InverseFactor::kProbes of those rows, from the first to the last. Every
/// other row is unchanged, the others are moved by one and two length scales.
Eigen::MatrixXd columnsBeside(const ScaledRows& X, const std::vector<int>& rows, double signal2,
                              const Poll& poll)
{
    const auto count = static_cast<Eigen::Index>(rows.size());
    const Eigen::RowVectorXd step =
        X.perLength.cwiseInverse() / std::sqrt(static_cast<double>(X.X.cols()));
    Eigen::MatrixXd columns(X.X.rows(), InverseFactor::kProbes);
    for (Eigen::Index p = 0; p < columns.cols(); ++p) {
        callPoll(poll);
        const int row = rows[static_cast<std::size_t>(InverseFactor::probe(p, count))];
        Eigen::RowVectorXd x = X.X.row(row);
        for (Eigen::Index d = 0; p % 2 == 1 && d < x.size(); ++d)
            x[d] += (p % 4 == 3 ? 2.0 : 1.0) * ((d + p / 4) % 2 == 0 ? step[d] : -step[d]);
        columns.col(p) = covarianceColumn(X, x, signal2);
    }
    return columns;
}

Eigen::MatrixXd transposed(const Eigen::MatrixXd& F, const Poll& poll)
{
    Eigen::MatrixXd turned(F.cols(), F.rows());
    PolledWork work(poll);
    for (Eigen::Index j = 0; j < turned.cols(); ++j) {
        turned.col(j) = F.row(j).transpose();
        work.done(turned.rows());
    }
    return turned;
}

}  // namespace

double errorBoundAt(double rcond)
{
    constexpr double kPerCondition = 1e-2 * kMinRcond;
    return std::max(1e-9, kPerCondition / rcond);
}

void requireTrainable(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                      const Hyperparameters& hyper)
{
    if (X.rows() < 1 || X.rows() != y.size() || X.cols() != hyper.lengthScale.size())
        throw std::invalid_argument(fmt::format(
            "Gaussian process: {} × {} inputs do not fit {} outputs and {} length scales", X.rows(),
            X.cols(), y.size(), hyper.lengthScale.size()));
    if (!X.allFinite() || !y.allFinite())
        throw std::invalid_argument("Gaussian process: every input and output must be finite");
    if (!hyper.lengthScale.allFinite() || !(hyper.lengthScale.array() > 0.0).all()
        || !(hyper.signalSd > 0.0) || !std::isfinite(hyper.signalSd) || !(hyper.noiseSd >= 0.0)
        || !std::isfinite(hyper.noiseSd))
        throw std::invalid_argument("Gaussian process: length scales and signal sd must be "
                                    "positive and the noise sd 0 or more");
}

void requireRowVariance(const Eigen::VectorXd& rowVariance, Eigen::Index rows)
{
    if (rowVariance.size() == 0) return;
    if (rowVariance.size() != rows || !rowVariance.allFinite() || rowVariance.minCoeff() < 0.0)
        throw std::invalid_argument(
            "Gaussian process: needs a variance of 0 or more for each row, or none");
}

GaussianProcess::GaussianProcess(Eigen::MatrixXd X, const Eigen::VectorXd& y, Hyperparameters hyper,
                                 double outputMean, const Poll& poll, Eigen::VectorXd rowVariance)
    : X_(std::move(X)), hyper_(std::move(hyper)), outputMean_(outputMean),
      rowVariance_(std::move(rowVariance))
{
    requireTrainable(X_, y, hyper_);
    requireRowVariance(rowVariance_, y.size());
    if (!std::isfinite(outputMean))
        throw std::invalid_argument("Gaussian process: the output mean must be finite");
    Factor found = factorWithJitter(X_, hyper_, rowVariance_, poll);
    jitter_ = found.jitter;
    rcond_ = found.rcond;
    alpha_ = y;
    solveWithFactor(found.R, alpha_, poll);
    largestMean_ = alpha_.lpNorm<1>() * hyper_.signalSd * hyper_.signalSd;
    if (!std::isfinite(largestMean_))
        throw std::invalid_argument("Gaussian process: the outputs overflow in units of the noise");
    inverse_.emplace(
        std::move(found.R), [this](const Poll& again) { return factor(again); },
        [this](const Eigen::MatrixXd& R, const Poll& again) { return reduce(R, again); });
}

GaussianProcess::GaussianProcess(Eigen::MatrixXd Z, SparseProcess process, Hyperparameters hyper,
                                 double outputMean, const Poll& poll)
    : X_(std::move(Z)), hyper_(std::move(hyper)), outputMean_(outputMean), jitter_(process.jitter),
      rcond_(process.rcond), alpha_(std::move(process.weights))
{
    largestMean_ = alpha_.lpNorm<1>() * hyper_.signalSd * hyper_.signalSd;
    if (!std::isfinite(outputMean) || !std::isfinite(largestMean_) || !process.F.allFinite())
        throw std::invalid_argument("sparse Gaussian process: numbers overflow");
    std::vector<int> rows(static_cast<std::size_t>(X_.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    inverse_.emplace(GivenInverse{
        process.F.transpose(),
        columnsBeside(inLengthScales(X_, hyper_), rows, hyper_.signalSd * hyper_.signalSd, poll)});
}

std::unique_ptr<GaussianProcess> GaussianProcess::sparse(Eigen::MatrixXd X,
                                                         const Eigen::VectorXd& y, int inducing,
                                                         Hyperparameters hyper, double outputMean,
                                                         const Poll& poll,
                                                         Eigen::VectorXd rowVariance)
{
    if (inducing >= X.rows())
        return std::make_unique<GaussianProcess>(std::move(X), y, std::move(hyper), outputMean,
                                                 poll, std::move(rowVariance));
    SparseProcess process = sparseProcess(X, y, inducing, hyper, poll, rowVariance);
    Eigen::MatrixXd Z = X(process.inducing, Eigen::all);
    return std::unique_ptr<GaussianProcess>(
        new GaussianProcess(std::move(Z), std::move(process), std::move(hyper), outputMean, poll));
}

Eigen::MatrixXd GaussianProcess::factor(const Poll& poll) const
{
    Eigen::MatrixXd K = noisyCovariance(X_, hyper_, rowVariance_, jitter_, poll);
    choleskyUpper(K, poll);  // as when this process was built
    return K;
}

/// Judges the reduction by the true variance at rows that were left out, and beside such rows.
std::optional<ReducedInverse> GaussianProcess::reduce(const Eigen::MatrixXd& R,
                                                      const Poll& poll) const
{
    if (jitter_ > 0.0) return std::nullopt;            // R then belongs to another covariance
    if (rowVariance_.size() > 0) return std::nullopt;  // rows are not chosen by their own noise
    std::optional<ReducedVariance> reduced = reducedVariance(X_, hyper_, poll);
    if (!reduced) return std::nullopt;
    const std::vector<int> others = rowsNotIn(reduced->rows, X_.rows());
    const double signal2 = hyper_.signalSd * hyper_.signalSd;
    const double noise2 = hyper_.noiseSd * hyper_.noiseSd;
    Eigen::MatrixXd columns = columnsBeside(inLengthScales(X_, hyper_), others, signal2, poll);
    ReducedInverse inverse{std::move(reduced->rows), transposed(reduced->F, poll), {}, {}, {},
                           mostSingleError(hyper_)};
    inverse.probes = columns(inverse.order, Eigen::all);
    inverse.order.insert(inverse.order.end(), others.begin(), others.end());
    solveTransposed(R, columns, poll);
    inverse.squares = columns.colwise().squaredNorm();
    inverse.weights = noise2 / (signal2 + noise2 - inverse.squares.array()).max(noise2);
    return inverse;
}

Precision GaussianProcess::usable(Precision wanted, const Poll& poll) const
{
    if (wanted == Precision::Double) return wanted;
    return singleError(poll) <= mostSingleError(hyper_) ? Precision::Single : Precision::Double;
}

void GaussianProcess::prepare(Precision wanted, const Poll& poll) const
{
    if (usable(wanted, poll) == Precision::Double) inverse_->panels(poll);
}

Normal GaussianProcess::predict(const Eigen::VectorXd& x) const
{
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
    SceneConditional(*this, x, {}, Precision::Double)
        .predict(Eigen::MatrixXd(0, 1), mean, variance);
    return {mean[0], variance[0]};
}

}  // namespace terratact
