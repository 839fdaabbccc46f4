#include "core/learn/gaussian_process.h"

#include <cblas.h>
#include <fmt/format.h>
#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/learn/covariance_kernels.h"

namespace terratact {

namespace {

constexpr int kLanes = 8;

int padded(Eigen::Index n)
{
    return static_cast<int>((n + kLanes - 1) / kLanes * kLanes);
}

std::size_t area(int a, int b)
{
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

void checkArguments(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
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

/// X in length scales, row-major U × d.
AlignedDoubles scaledRows(const Eigen::MatrixXd& X, const Eigen::VectorXd& lengthScale)
{
    AlignedDoubles scaled(static_cast<std::size_t>(X.size()));
    double* out = scaled.data();
    for (Eigen::Index u = 0; u < X.rows(); ++u)
        for (Eigen::Index d = 0; d < X.cols(); ++d) *out++ = X(u, d) / lengthScale[d];
    return scaled;
}

/// The signal part k(X, X), upper triangle (lower one not set), by blocks of columns.
Eigen::MatrixXd signalCovariance(const Eigen::MatrixXd& X, const Hyperparameters& hyper)
{
    constexpr int kBlock = 64;
    const int U = static_cast<int>(X.rows());
    const int d = static_cast<int>(X.cols());
    const AlignedDoubles rows = scaledRows(X, hyper.lengthScale);
    const AlignedDoubles noWeight(static_cast<std::size_t>(U));
    AlignedDoubles z(area(d, kBlock));
    AlignedDoubles block(area(U, kBlock));
    Eigen::MatrixXd K(U, U);
    for (int first = 0; first < U; first += kBlock) {
        const int columns = std::min(kBlock, U - first);
        for (int c = 0; c < columns; ++c)
            for (int j = 0; j < d; ++j) z.data()[j * kBlock + c] = rows.data()[(first + c) * d + j];
        // Rows before the block are the upper triangle of its columns.
        const int count = first + columns;
        covarianceKernels().covariances(rows.data(), noWeight.data(), z.data(), count, d, kBlock,
                                        hyper.signalSd * hyper.signalSd, block.data());
        for (int c = 0; c < columns; ++c)
            for (int u = 0; u <= first + c; ++u) K(u, first + c) = block.data()[u * kBlock + c];
    }
    return K;
}

/// Adds the noise and factorises in place: upper triangle becomes R with K = Rᵀ R (R = Lᵀ).
void factorise(Eigen::MatrixXd& K, double noiseSd)
{
    K.diagonal().array() += noiseSd * noiseSd;
    const auto n = static_cast<lapack_int>(K.rows());
    const lapack_int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', n, K.data(), n);
    if (info != 0 || !K.diagonal().allFinite())
        throw std::invalid_argument(
            fmt::format("Gaussian process: the covariance of {} rows is not positive definite "
                        "(doubled rows, noise sd {:.3g} m)",
                        K.rows(), noiseSd));
}

/// α = K⁻¹ y from the factor.
Eigen::VectorXd solve(const Eigen::MatrixXd& R, const Eigen::VectorXd& y)
{
    Eigen::VectorXd alpha = y;
    const auto n = static_cast<lapack_int>(R.rows());
    LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'U', n, 1, R.data(), n, alpha.data(), n);
    return alpha;
}

/// Rows of the lower triangle L⁻¹ = (R⁻¹)ᵀ in panels, zero above the diagonal and beyond the last row.
AlignedDoubles packTriangle(const Eigen::MatrixXd& inverseR, int paddedRows)
{
    std::size_t size = 0;
    for (int first = 0; first < paddedRows; first += kPanelRows)
        size += area(kPanelRows, first + kPanelRows);
    AlignedDoubles panels(size);
    double* out = panels.data();
    const auto U = static_cast<int>(inverseR.rows());
    for (int first = 0; first < paddedRows; first += kPanelRows)
        for (int j = 0; j < first + kPanelRows; ++j)
            for (int i = first; i < first + kPanelRows; ++i)
                *out++ = (i < U && j <= i) ? inverseR(j, i) : 0.0;
    return panels;
}

}  // namespace

double* AlignedDoubles::data()
{
    return const_cast<double*>(std::as_const(*this).data());
}

const double* AlignedDoubles::data() const
{
    const auto address = reinterpret_cast<std::uintptr_t>(values.data());
    return values.data() + ((64 - address % 64) % 64) / sizeof(double);
}

GaussianProcess::GaussianProcess(Eigen::MatrixXd X, const Eigen::VectorXd& y, Hyperparameters hyper,
                                 double outputMean)
    : X_(std::move(X)), hyper_(std::move(hyper)), outputMean_(outputMean),
      paddedRows_(padded(X_.rows()))
{
    checkArguments(X_, y, hyper_);
    if (!std::isfinite(outputMean))
        throw std::invalid_argument("Gaussian process: the output mean must be finite");
    Eigen::MatrixXd K = signalCovariance(X_, hyper_);
    factorise(K, hyper_.noiseSd);
    alpha_ = solve(K, y);
    const auto n = static_cast<lapack_int>(K.rows());
    LAPACKE_dtrtri(LAPACK_COL_MAJOR, 'U', 'N', n, K.data(), n);
    panels_ = packTriangle(K, paddedRows_);
}

Normal GaussianProcess::predict(const Eigen::VectorXd& x) const
{
    if (x.size() != X_.cols() || !x.allFinite())
        throw std::invalid_argument(fmt::format("a prediction needs {} finite inputs", X_.cols()));
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
    SceneConditional(*this, x, {}).predict(Eigen::MatrixXd(0, 1), mean, variance);
    return {mean[0], variance[0]};
}

SceneConditional::SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x,
                                   std::vector<int> moving)
    : gp_(gp), moving_(std::move(moving)),
      scaledX_(area(gp.paddedRows_, static_cast<int>(moving_.size()))),
      logWeight_(static_cast<std::size_t>(gp.paddedRows_))
{
    const Eigen::VectorXd& scale = gp.hyper_.lengthScale;
    Eigen::VectorXd distance2 = Eigen::VectorXd::Zero(gp.rows());
    for (int d = 0; d < gp.inputs(); ++d)
        if (std::find(moving_.begin(), moving_.end(), d) == moving_.end())
            distance2.array() += ((gp.X_.col(d).array() - x[d]) / scale[d]).square();
    const auto m = static_cast<Eigen::Index>(moving_.size());
    for (Eigen::Index u = 0; u < gp.rows(); ++u) {
        logWeight_.data()[u] = -0.5 * distance2[u];
        for (Eigen::Index j = 0; j < m; ++j) {
            const int d = moving_[static_cast<std::size_t>(j)];
            scaledX_.data()[u * m + j] = gp.X_(u, d) / scale[d];
        }
    }
}

void SceneConditional::predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean,
                               Eigen::VectorXd& variance)
{
    const int U = gp_.paddedRows_;
    const int rows = static_cast<int>(gp_.rows());
    const int m = static_cast<int>(moving_.size());
    const int n = static_cast<int>(inputs.cols());
    const int C = padded(n);
    if (covariance_.values.size() < static_cast<Eigen::Index>(area(U, C))) {
        scaledZ_ = AlignedDoubles(area(std::max(m, 1), C));
        covariance_ = AlignedDoubles(area(U, C));
        squares_ = AlignedDoubles(static_cast<std::size_t>(C));
    }
    for (int j = 0; j < m; ++j) {
        const double scale = gp_.hyper_.lengthScale[moving_[static_cast<std::size_t>(j)]];
        for (int c = 0; c < n; ++c) scaledZ_.data()[j * C + c] = inputs(j, c) / scale;
    }
    const double signal2 = gp_.hyper_.signalSd * gp_.hyper_.signalSd;
    const CovarianceKernels& kernels = covarianceKernels();
    kernels.covariances(scaledX_.data(), logWeight_.data(), scaledZ_.data(), rows, m, C, signal2,
                        covariance_.data());
    kernels.sumsOfSquares(gp_.panels_.data(), covariance_.data(), U, C, squares_.data());

    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Rows> k(covariance_.data(), rows, C);
    mean = (k.leftCols(n).transpose() * gp_.alpha_).array() + gp_.outputMean_;
    const double prior = signal2 + gp_.hyper_.noiseSd * gp_.hyper_.noiseSd;
    const double floor =
        gp_.hyper_.noiseSd * gp_.hyper_.noiseSd;  // rounding must not go below the noise
    variance = (prior - Eigen::Map<const Eigen::ArrayXd>(squares_.data(), n)).max(floor).matrix();
}

Likelihood negativeLogLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                 const Hyperparameters& hyper)
{
    checkArguments(X, y, hyper);
    const Eigen::Index U = X.rows();
    const Eigen::Index d = X.cols();
    const auto n = static_cast<lapack_int>(U);
    const Eigen::MatrixXd signal = signalCovariance(X, hyper);
    Eigen::MatrixXd W = signal;
    factorise(W, hyper.noiseSd);
    const Eigen::VectorXd alpha = solve(W, y);
    Likelihood result;
    result.negativeLog = 0.5 * y.dot(alpha) + W.diagonal().array().log().sum()
                       + 0.5 * static_cast<double>(U) * std::log(2.0 * std::numbers::pi);

    LAPACKE_dpotri(LAPACK_COL_MAJOR, 'U', n, W.data(), n);
    W.triangularView<Eigen::Upper>() -= alpha * alpha.transpose();  // K⁻¹ − α αᵀ
    const double trace = W.diagonal().sum();
    W.triangularView<Eigen::Upper>() = W.cwiseProduct(signal);  // M: ∘ k(X, X)

    // ½ Σ M_ij (z_i − z_j)² = Σ_i r_i z_i² − zᵀ M z with z = x_d / ℓ_d and row sums r.
    const Eigen::MatrixXd Z = X * hyper.lengthScale.cwiseInverse().asDiagonal();
    Eigen::MatrixXd ZandOne(U, d + 1);
    ZandOne << Z, Eigen::VectorXd::Ones(U);
    Eigen::MatrixXd MZ(U, d + 1);
    cblas_dsymm(CblasColMajor, CblasLeft, CblasUpper, n, static_cast<int>(d + 1), 1.0, W.data(), n,
                ZandOne.data(), n, 0.0, MZ.data(), n);
    const Eigen::VectorXd rowSums = MZ.col(d);
    result.gradient.resize(d + 2);
    for (Eigen::Index k = 0; k < d; ++k)
        result.gradient[k] = rowSums.dot(Z.col(k).cwiseAbs2()) - Z.col(k).dot(MZ.col(k));
    result.gradient[d] = rowSums.sum();
    result.gradient[d + 1] = hyper.noiseSd * hyper.noiseSd * trace;
    return result;
}

}  // namespace terratact
