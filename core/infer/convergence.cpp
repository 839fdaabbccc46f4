#include "core/infer/convergence.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace terratact {
namespace {

using Draws = Eigen::Ref<const Eigen::MatrixXd>;
using Eigen::Index;

void require(const Draws& draws)
{
    if (draws.size() == 0) throw std::invalid_argument("convergence: no draws");
    if (!draws.allFinite()) throw std::invalid_argument("convergence: a draw is not finite");
}

bool allEqual(const Draws& x)
{
    return x.maxCoeff() == x.minCoeff();
}

/// Every column has one value only.
bool columnsConstant(const Draws& x)
{
    return ((x.colwise().maxCoeff() - x.colwise().minCoeff()).array() == 0.0).all();
}

/// n × chains → ⌊n/2⌋ × 2 chains.
Eigen::MatrixXd halves(const Draws& x)
{
    const Index half = x.rows() / 2;
    Eigen::MatrixXd split(half, 2 * x.cols());
    split << x.topRows(half), x.bottomRows(half);
    return split;
}

/// Ranks 1 … S over the whole matrix; equal values share their average rank.
Eigen::MatrixXd ranks(const Eigen::MatrixXd& x, PolledWork& work)
{
    struct Placed {
        double value;
        Index at;
    };
    std::vector<Placed> order;
    order.reserve(static_cast<std::size_t>(x.size()));
    for (Index at = 0; at < x.size(); ++at) {
        work.done();
        order.push_back({x(at), at});
    }
    std::sort(order.begin(), order.end(), [&work](const Placed& a, const Placed& b) {
        work.done();
        return a.value < b.value;
    });

    Eigen::MatrixXd rank(x.rows(), x.cols());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && order[end].value == order[begin].value) ++end;
        const double shared = 0.5 * static_cast<double>(begin + 1 + end);
        work.done(static_cast<long>(end - begin));
        for (std::size_t i = begin; i < end; ++i) rank(order[i].at) = shared;
    }
    return rank;
}

// Plain double arithmetic: 1e-15 is enough here, and far faster than long double.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// Vehtari et al. (2021), eq. 14: z = Φ⁻¹((r − 3/8) / (S + 1/4)).
Eigen::MatrixXd normalScores(const Eigen::MatrixXd& x, const Poll& poll)
{
    constexpr long kUnits = 4;  // of work
    PolledWork work(poll);
    const double size = static_cast<double>(x.size());
    return ranks(x, work).unaryExpr([size, &work](double r) {
        work.done(kUnits);
        const double p = (r - 0.375) / (size + 0.25);
        return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p, InDouble());
    });
}

double median(Eigen::MatrixXd draws, const Poll& poll)
{
    PolledWork work(poll);
    double* const begin = draws.data();
    double* const middle = begin + draws.size() / 2;
    std::nth_element(begin, middle, begin + draws.size(), [&work](double a, double b) {
        work.done();
        return a < b;
    });
    if (draws.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(begin, middle));
}

double sampleVariance(const Eigen::VectorXd& x)
{
    return (x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1);
}

/// Eq. 1 to 4 for half chains that are already normal scores; z: n × m.  1 where all are equal.
double splitRhat(const Eigen::MatrixXd& z)
{
    if (allEqual(z)) return 1.0;
    const double n = static_cast<double>(z.rows());
    const Eigen::VectorXd means = z.colwise().mean();
    const double between = n * sampleVariance(means);
    double within = 0.0;
    for (const auto& chain : z.colwise()) within += sampleVariance(chain);
    within /= static_cast<double>(z.cols());
    return std::min(std::sqrt((between / within + n - 1.0) / n), kRhatNever);
}

/// Mean autocovariance of the chains at one lag (divisor n, every chain about its own mean).
/// centred: n × m.
double autocovariance(const Eigen::MatrixXd& centred, Index lag)
{
    const Index rest = centred.rows() - lag;
    const double sum = centred.topRows(rest).cwiseProduct(centred.bottomRows(rest)).sum();
    return sum / static_cast<double>(centred.size());
}

/// Estimated autocorrelations up to where the sums of neighbouring pairs turn negative, then a last
/// even one (Geyer's initial positive sequence).
std::vector<double> positiveSequence(const Eigen::MatrixXd& z, const Poll& poll)
{
    PolledWork work(poll);
    const Index n = z.rows();
    const Eigen::MatrixXd centred = z.rowwise() - z.colwise().mean();
    const Eigen::VectorXd means = z.colwise().mean();
    const double atZero = autocovariance(centred, 0);
    const double meanVariance = atZero * static_cast<double>(n) / static_cast<double>(n - 1);
    const double total = atZero + sampleVariance(means);  // var⁺, eq. 3
    const auto rho = [&](Index lag) {                     // eq. 10
        work.done(z.size() / 4);
        return 1.0 - (meanVariance - autocovariance(centred, lag)) / total;
    };

    std::vector<double> kept;
    double even = 1.0;
    double odd = rho(1);
    Index lag = 0;
    while (lag < n - 5 && even + odd > 0.0) {
        kept.push_back(even);
        kept.push_back(odd);
        lag += 2;
        even = rho(lag);
        odd = rho(lag + 1);
    }
    // Halves of fewer than six draws: as posterior, the lag 0 alone, counted twice (τ = 2).
    if (kept.empty()) return {even, even};
    kept.push_back(even > 0.0 || even + odd >= 0.0 ? even : 0.0);
    return kept;
}

/// Pairs after the first may not grow (Geyer's initial monotone sequence).
void makeMonotone(std::vector<double>& rho)
{
    for (std::size_t t = 2; t + 2 < rho.size(); t += 2) {
        const double before = rho[t - 2] + rho[t - 1];
        if (rho[t] + rho[t + 1] > before) rho[t] = rho[t + 1] = 0.5 * before;
    }
}

}  // namespace

RankedDraws::RankedDraws(const Eigen::Ref<const Eigen::MatrixXd>& draws, Poll poll, double bound)
    : draws_(draws), poll_(std::move(poll)), bound_(bound)
{
    require(draws);
}

const Eigen::MatrixXd& RankedDraws::scores()
{
    if (scores_.size() == 0) scores_ = normalScores(halves(draws_), poll_);
    return scores_;
}

bool RankedDraws::heldByBound() const
{
    return (draws_.array() == bound_).all();
}

double RankedDraws::rhat()
{
    if (draws_.rows() < 4) return kRhatNever;
    if (heldByBound()) return 1.0;
    if (columnsConstant(scores())) return kRhatNever;
    callPoll(poll_);
    const Eigen::MatrixXd folded = (draws_.array() - median(draws_, poll_)).abs();
    return std::max(splitRhat(scores()), splitRhat(normalScores(halves(folded), poll_)));
}

double RankedDraws::ess()
{
    const auto chains = static_cast<double>(draws_.cols());
    if (draws_.rows() < 6) return chains;
    if (heldByBound()) return static_cast<double>(draws_.size());
    const Eigen::MatrixXd& z = scores();
    callPoll(poll_);
    if (columnsConstant(z)) return chains;

    std::vector<double> rho = positiveSequence(z, poll_);
    makeMonotone(rho);
    // τ = −1 + 2 Σ ρ_t + ρ_last, eq. 12 and 13
    const double sum = std::accumulate(rho.begin(), rho.end() - 1, 0.0);
    const double size = static_cast<double>(z.size());
    const double tau = std::max(-1.0 + 2.0 * sum + rho.back(), 1.0 / std::log10(size));
    return size / tau;
}

}  // namespace terratact
