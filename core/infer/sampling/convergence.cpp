#include "core/infer/sampling/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/normal.h"

namespace terratact {
namespace {

using Draws = Eigen::Ref<const Eigen::MatrixXd>;
using Eigen::Index;

constexpr long kNumbersPerUnit = 8;  // numbers per unit of PolledWork that are only read

void require(const Draws& draws, const Poll& poll)
{
    if (draws.size() == 0) throw std::invalid_argument("convergence: no draws");
    PolledWork work(poll);
    for (const auto& chain : draws.colwise()) {
        if (!chain.allFinite()) throw std::invalid_argument("convergence: a draw is not finite");
        work.done(chain.size() / kNumbersPerUnit);
    }
}

/// Returns true if every column holds one value only.
bool columnsConstant(const Draws& x, const Poll& poll)
{
    PolledWork work(poll);
    for (const auto& chain : x.colwise()) {
        if (chain.maxCoeff() != chain.minCoeff()) return false;
        work.done(chain.size() / kNumbersPerUnit);
    }
    return true;
}

/// Maps n × chains to ⌊n/2⌋ × 2 chains of f(x).
template <class F>
Eigen::MatrixXd halves(const Draws& x, const Poll& poll, F f)
{
    PolledWork work(poll);
    const Index half = x.rows() / 2;
    Eigen::MatrixXd split(half, 2 * x.cols());
    for (Index c = 0; c < x.cols(); ++c) {
        transformPolled(x.col(c).data(), half, split.col(c).data(), work, f);
        transformPolled(x.col(c).tail(half).data(), half, split.col(x.cols() + c).data(), work, f);
    }
    return split;
}

Eigen::MatrixXd halves(const Draws& x, const Poll& poll)
{
    return halves(x, poll, [](double value) { return value; });
}

/// Returns ranks 1 … S over the whole matrix; equal values share their average rank.
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

/// Returns normal scores: Vehtari et al. (2021), eq. 14: z = Φ⁻¹((r − 3/8) / (S + 1/4)).
Eigen::MatrixXd normalScores(const Eigen::MatrixXd& x, const Poll& poll)
{
    constexpr long kUnits = 4;  // units of work
    PolledWork work(poll);
    const double size = static_cast<double>(x.size());
    return ranks(x, work).unaryExpr([size, &work](double r) {
        work.done(kUnits);
        return normalQuantile((r - 0.375) / (size + 0.25));
    });
}

double median(const Draws& draws, const Poll& poll)
{
    PolledWork work(poll);
    Eigen::MatrixXd copy(draws.rows(), draws.cols());
    for (Index c = 0; c < draws.cols(); ++c)
        transformPolled(draws.col(c).data(), draws.rows(), copy.col(c).data(), work,
                        [](double value) { return value; });
    double* const begin = copy.data();
    double* const middle = begin + copy.size() / 2;
    std::nth_element(begin, middle, begin + copy.size(), [&work](double a, double b) {
        work.done();
        return a < b;
    });
    if (copy.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(begin, middle));
}

double sampleVariance(const Eigen::VectorXd& x)
{
    return (x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1);
}

/// Computes eq. 1 to 4 for half chains that are already normal scores; z: n × m. Returns 1 if all
/// are equal.
double splitRhat(const Eigen::MatrixXd& z, const Poll& poll)
{
    if (columnsConstant(z, poll) && z.row(0).maxCoeff() == z.row(0).minCoeff()) return 1.0;
    PolledWork work(poll);
    const double n = static_cast<double>(z.rows());
    Eigen::VectorXd means(z.cols());
    double within = 0.0;
    for (Index c = 0; c < z.cols(); ++c) {
        const auto chain = z.col(c);
        means[c] = chain.mean();
        within += (chain.array() - means[c]).square().sum() / (n - 1.0);
        work.done(2 * chain.size() / kNumbersPerUnit);
    }
    within /= static_cast<double>(z.cols());
    const double between = n * sampleVariance(means);
    return std::min(std::sqrt((between / within + n - 1.0) / n), kRhatNever);
}

/// Returns the mean autocovariance of the chains at one lag. The divisor is n; every chain is about
/// its own mean. centred: n × m.
double autocovariance(const Eigen::MatrixXd& centred, Index lag, PolledWork& work)
{
    const Index rest = centred.rows() - lag;
    double sum = 0.0;
    for (const auto& chain : centred.colwise()) {
        sum += chain.head(rest).dot(chain.tail(rest));
        work.done(rest / kNumbersPerUnit);
    }
    return sum / static_cast<double>(centred.size());
}

/// Returns autocorrelations until the sum of a neighbouring pair turns negative, then one last even
/// lag (Geyer's initial positive sequence).
std::vector<double> positiveSequence(const Eigen::MatrixXd& z, const Poll& poll)
{
    PolledWork work(poll);
    const Index n = z.rows();
    Eigen::MatrixXd centred(n, z.cols());
    Eigen::VectorXd means(z.cols());
    for (Index c = 0; c < z.cols(); ++c) {
        const double mean = means[c] = z.col(c).mean();
        transformPolled(z.col(c).data(), n, centred.col(c).data(), work,
                        [mean](double value) { return value - mean; });
    }
    const double atZero = autocovariance(centred, 0, work);
    const double meanVariance = atZero * static_cast<double>(n) / static_cast<double>(n - 1);
    const double total = atZero + sampleVariance(means);  // var⁺, eq. 3
    const auto rho = [&](Index lag) {                     // eq. 10
        return 1.0 - (meanVariance - autocovariance(centred, lag, work)) / total;
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
    // Halves of fewer than six draws use lag 0 alone, counted twice (τ = 2), as posterior does.
    if (kept.empty()) return {even, even};
    kept.push_back(even > 0.0 || even + odd >= 0.0 ? even : 0.0);
    return kept;
}

/// Makes no pair larger than the pair before it (Geyer's initial monotone sequence).
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
    require(draws, poll_);
}

const Eigen::MatrixXd& RankedDraws::scores()
{
    if (scores_.size() == 0) scores_ = normalScores(halves(draws_, poll_), poll_);
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
    if (columnsConstant(scores(), poll_)) return kRhatNever;
    const double centre = median(draws_, poll_);
    const Eigen::MatrixXd folded =
        halves(draws_, poll_, [centre](double value) { return std::abs(value - centre); });
    return std::max(splitRhat(scores(), poll_), splitRhat(normalScores(folded, poll_), poll_));
}

double RankedDraws::ess()
{
    const auto chains = static_cast<double>(draws_.cols());
    if (draws_.rows() < 6) return chains;
    if (heldByBound()) return static_cast<double>(draws_.size());
    const Eigen::MatrixXd& z = scores();
    if (columnsConstant(z, poll_)) return chains;

    std::vector<double> rho = positiveSequence(z, poll_);
    makeMonotone(rho);
    // τ = −1 + 2 Σ ρ_t + ρ_last, eq. 12 and 13
    const double sum = std::accumulate(rho.begin(), rho.end() - 1, 0.0);
    const double size = static_cast<double>(z.size());
    const double tau = std::max(-1.0 + 2.0 * sum + rho.back(), 1.0 / std::log10(size));
    return size / tau;
}

}  // namespace terratact
