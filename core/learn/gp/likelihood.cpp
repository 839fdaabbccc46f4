#include "core/learn/gp/likelihood.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/learn/gp/gaussian_process.h"
#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/covariance_block.h"
#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/likelihood_kernels.h"
#include "core/learn/kernels/symmetric_panels.h"

namespace terratact {

namespace {

constexpr int kColumns = SymmetricPanels::kPanelColumns;
constexpr int kRows = 64;  // rows of covariances at a time: they stay in the cache

/// Inputs and their signal covariance k(X, X), panel by panel.
class SignalCovariance {
public:
    SignalCovariance(const Eigen::MatrixXd& X, const Hyperparameters& hyper)
        : U_(static_cast<int>(X.rows())), d_(static_cast<int>(X.cols())),
          signal2_(hyper.signalSd * hyper.signalSd), rows_(entriesOf(U_, d_)),
          perLength_(entriesOf(1, d_)), columns_(entriesOf(d_, kColumns)),
          groups_(entriesOf(d_, kColumns))
    {
        const ScaledRows scaled = inLengthScales(X, hyper);
        double* out = rows_.data();
        for (int u = 0; u < U_; ++u)
            for (int j = 0; j < d_; ++j) *out++ = X(u, j);
        std::copy_n(scaled.perLength.data(), d_, perLength_.data());
    }

    int inputs() const { return d_; }
    double perLength(int d) const { return perLength_.data()[d]; }
    const double* row(int u) const { return rows_.data() + static_cast<long>(u) * d_; }
    /// d × kColumns, of the current panel
    const double* columns() const { return columns_.data(); }

    void setPanel(int panel)
    {
        const int first = panel * kColumns;
        for (int c = 0; c < kColumns; ++c)
            for (int j = 0; j < d_; ++j) {
                const double x = first + c < U_ ? row(first + c)[j] : 0.0;
                columns_.data()[j * kColumns + c] = x;
                groups_.data()[(c / kGroup * d_ + j) * kGroup + c % kGroup] = x;
            }
    }

    /// Computes k of `count` ≤ kRows rows from u on with the panel's columns: count × kColumns.
    void rows(int u, int count, double* out)
    {
        const CovarianceInput in{
            row(u), perLength_.data(), zeros_.data(), zeros_.data(), count, count, d_, signal2_};
        for (int c = 0; c < kColumns; c += kGroup) {
            covarianceKernels().covariances(in, groups_.data() + static_cast<long>(c) * d_,
                                            block_.data(), unused_.data());
            for (int r = 0; r < count; ++r)
                std::copy_n(block_.data() + static_cast<long>(r) * kGroup, kGroup,
                            out + static_cast<long>(r) * kColumns + c);
        }
    }

private:
    int U_, d_;
    double signal2_;
    AlignedArray<double> rows_;       // U × d
    AlignedArray<double> perLength_;  // d
    // of the current panel: d × kColumns; d × kGroup by groups
    AlignedArray<double> columns_, groups_;
    AlignedArray<double> zeros_{kRows};
    AlignedArray<double> block_{entriesOf(kRows, kGroup)}, unused_{kGroup};
};

void fill(SymmetricPanels& K, SignalCovariance& signal, double noiseSd,
          const Eigen::VectorXd& rowVariance, const Poll& poll)
{
    for (int panel = 0; panel < K.panels(); ++panel) {
        const int first = panel * kColumns;
        if (first >= K.size()) break;
        signal.setPanel(panel);
        for (int u = first; u < K.size(); u += kRows) {
            callPoll(poll);
            signal.rows(u, std::min(kRows, K.size() - u), K.row(panel, u));
        }
        for (int u = first; u < std::min(K.size(), first + kColumns); ++u)
            K.row(panel, u)[u - first] += noiseSd * noiseSd;
        for (int u = first; rowVariance.size() > 0 && u < std::min(K.size(), first + kColumns); ++u)
            K.row(panel, u)[u - first] += rowVariance[u];
    }
}

/// Returns true if K is singular to working precision.
bool isSingular(const SymmetricPanels::Factors& factors)
{
    constexpr double kRounding = 1e-14;
    const double ratio = factors.leastPivot / factors.mostPivot;
    return !(ratio * ratio >= kRounding);
}

/// Returns Σ over i > j of G_ij (z_id − z_jd)² for every input d, then the sum of G_ij:
///   G = (K⁻¹ − α αᵀ) ∘ k(X, X), z inputs in length scales.  K: −K⁻¹.
Eigen::VectorXd weightedSquares(const SymmetricPanels& K, SignalCovariance& signal,
                                const Eigen::VectorXd& alpha, const Poll& poll)
{
    const int d = signal.inputs();
    AlignedArray<double> sums(entriesOf(d + 1, kGroup));
    AlignedArray<double> block(entriesOf(kRows, kColumns));
    AlignedArray<double> alphaOfPanel(kColumns);
    for (int first = 0; first < K.size(); first += kColumns) {
        const int panel = first / kColumns;
        signal.setPanel(panel);
        const int own = std::min(kColumns, K.size() - first);
        std::copy_n(alpha.data() + first, own, alphaOfPanel.data());
        for (int u = first; u < K.size(); ++u) {
            const int r = (u - first) % kRows;
            if (r == 0) {
                callPoll(poll);
                signal.rows(u, std::min(kRows, K.size() - u), block.data());
            }
            double* S = block.data() + entriesOf(r, kColumns);
            const int left = std::min(kColumns, u - first);  // entries left of the diagonal
            const int columns = kGroup * groupsOf(left);
            std::fill(S + left, S + columns, 0.0);
            likelihoodKernels().addWeightedSquares(K.row(panel, u), S, alpha[u],
                                                   alphaOfPanel.data(), columns, signal.row(u),
                                                   signal.columns(), kColumns, d, sums.data());
        }
    }
    const Eigen::Map<const Eigen::MatrixXd> parts(sums.data(), kGroup, d + 1);
    Eigen::VectorXd sum = parts.colwise().sum().transpose();
    for (int j = 0; j < d; ++j) sum[j] = sum[j] * signal.perLength(j) * signal.perLength(j);
    return sum;
}

}  // namespace

Likelihood negativeLogLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                                 const Hyperparameters& hyper, const Poll& poll,
                                 const Eigen::VectorXd& rowVariance)
{
    requireTrainable(X, y, hyper);
    requireRowVariance(rowVariance, y.size());
    const auto U = static_cast<int>(X.rows());
    const Eigen::Index d = X.cols();
    SignalCovariance signal(X, hyper);
    SymmetricPanels K(U, poll);
    fill(K, signal, hyper.noiseSd, rowVariance, poll);
    Eigen::VectorXd alpha = y;
    SymmetricPanels::Factors factors;
    if (!K.invert(alpha, factors, poll) || isSingular(factors))
        throw std::invalid_argument(
            fmt::format("Gaussian process: the covariance of {} rows is not positive definite "
                        "(doubled rows, noise sd {:.3g} m)",
                        U, hyper.noiseSd));
    Likelihood result;
    result.negativeLog =
        0.5 * (factors.quadratic + factors.logDeterminant + U * std::log(2.0 * std::numbers::pi));

    const Eigen::VectorXd sums = weightedSquares(K, signal, alpha, poll);
    double trace = -alpha.squaredNorm();  // trace of K⁻¹ − α αᵀ
    for (int u = 0; u < U; ++u) trace -= K.row(u / kColumns, u)[u % kColumns];
    result.gradient.resize(d + 2);
    result.gradient.head(d) = sums.head(d);
    result.gradient[d] = 2.0 * sums[d] + hyper.signalSd * hyper.signalSd * trace;
    result.gradient[d + 1] = hyper.noiseSd * hyper.noiseSd * trace;
    if (!std::isfinite(result.negativeLog) || !result.gradient.allFinite())
        throw std::invalid_argument("Gaussian process: the likelihood overflows");
    return result;
}

}  // namespace terratact
