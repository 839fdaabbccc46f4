#include "tests/support/simulation_based_calibration.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <numeric>
#include <stdexcept>

namespace terratact {

namespace {

/// Returns P(χ² ≥ the counts' distance from equal counts).
double equalCountsProbability(const std::vector<int>& counts)
{
    const double expected =
        std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
    double chi2 = 0.0;
    for (const int count : counts) chi2 += (count - expected) * (count - expected) / expected;
    const boost::math::chi_squared law(static_cast<double>(counts.size()) - 1.0);
    return boost::math::cdf(boost::math::complement(law, chi2));
}

}  // namespace

void RankHistograms::add(const Eigen::VectorXd& truth, const Eigen::MatrixXd& draws)
{
    const auto quantities = static_cast<std::size_t>(truth.size());
    if (counts_.empty())
        counts_.assign(quantities, std::vector<int>(static_cast<std::size_t>(draws_) + 1));
    if (draws.cols() != draws_ || draws.rows() != truth.size() || counts_.size() != quantities)
        throw std::invalid_argument("every set needs the same quantities and number of draws");
    for (Eigen::Index q = 0; q < truth.size(); ++q) {
        const auto rank = (draws.row(q).array() < truth[q]).count();
        ++counts_[static_cast<std::size_t>(q)][static_cast<std::size_t>(rank)];
    }
}

double RankHistograms::pValue() const
{
    double smallest = 1.0;
    for (const std::vector<int>& counts : counts_)
        smallest = std::min(smallest, equalCountsProbability(counts));
    return std::min(1.0, static_cast<double>(counts_.size()) * smallest);
}

RankHistograms calibrationRanks(int sets, int draws, int burnIn,
                                const std::function<SimulatedSet()>& simulate,
                                const std::function<GibbsDraws(const GibbsProblem&)>& sample,
                                const std::function<Eigen::VectorXd(const Heights&)>& quantities)
{
    RankHistograms ranks(draws);
    for (int n = 0; n < sets; ++n) {
        SimulatedSet set = simulate();
        set.problem.chains = draws;
        set.problem.burnIn = burnIn;
        set.problem.keptPerChain = 1;
        set.problem.seed = static_cast<std::uint64_t>(n) + 1;
        const GibbsDraws result = sample(set.problem);
        const Eigen::VectorXd truth = quantities(set.truth);
        Eigen::MatrixXd drawn(truth.size(), draws);
        for (Eigen::Index c = 0; c < draws; ++c) {
            Heights h = set.truth;  // heights of the known bins
            for (std::size_t k = 0; k < result.bins.size(); ++k)
                h[static_cast<std::size_t>(result.bins[k])] = result.draws[k](0, c);
            drawn.col(c) = quantities(h);
        }
        ranks.add(truth, drawn);
    }
    return ranks;
}

}  // namespace terratact
