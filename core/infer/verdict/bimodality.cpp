#include "core/infer/verdict/bimodality.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace terratact {
namespace {

/// Returns the best split of sorted, centred values; betweenShare is 0 if all are equal.
TwoModes bestSplit(const std::vector<double>& x)
{
    const auto n = static_cast<double>(x.size());
    const double total = std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
    const double sum = std::accumulate(x.begin(), x.end(), 0.0);
    TwoModes best;
    double below = 0.0;
    for (std::size_t k = 1; k < x.size(); ++k) {
        below += x[k - 1];
        if (!(x[k - 1] < x[k])) continue;  // equal draws stay together
        const auto low = static_cast<double>(k);
        const double lowMean = below / low;
        const double highMean = (sum - below) / (n - low);
        const double distance = highMean - lowMean;
        const double between = low * (n - low) * distance * distance / (n * total);
        if (between > best.betweenShare)
            best = {
                std::midpoint(x[k - 1], x[k]), lowMean, highMean, low / n, (n - low) / n, between};
    }
    return best;
}

bool allFinite(const std::vector<double>& draws)
{
    return std::all_of(draws.begin(), draws.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

std::optional<TwoModes> twoModes(std::vector<double> draws)
{
    if (!allFinite(draws)) throw std::invalid_argument("twoModes: a draw is not finite");
    if (draws.empty()) return std::nullopt;
    std::sort(draws.begin(), draws.end());
    const double mean =
        std::accumulate(draws.begin(), draws.end(), 0.0) / static_cast<double>(draws.size());
    for (double& x : draws) x -= mean;

    TwoModes modes = bestSplit(draws);
    if (!(modes.betweenShare > kMinBetweenShare)) return std::nullopt;
    if (std::min(modes.lowShare, modes.highShare) < kMinModeShare) return std::nullopt;
    if (!(modes.highMean - modes.lowMean > kMinModeDistance)) return std::nullopt;
    for (double* const height : {&modes.split, &modes.lowMean, &modes.highMean}) *height += mean;
    return modes;
}

std::array<std::optional<TwoModes>, kBins> twoModes(const TerrainEstimate& estimate)
{
    std::array<std::optional<TwoModes>, kBins> result;
    std::vector<double> draws(estimate.draws.size());
    for (std::size_t i = 0; i < kBins; ++i) {
        std::transform(estimate.draws.begin(), estimate.draws.end(), draws.begin(),
                       [i](const Heights& h) { return h[i]; });
        if (allFinite(draws)) result[i] = twoModes(draws);
    }
    return result;
}

}  // namespace terratact
