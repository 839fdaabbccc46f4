#include "core/infer/verdict/obstacle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/infer/estimate/hazards.h"

namespace terratact {

StepProbability stepProbability(const std::vector<Heights>& draws, double limit, int firstBin,
                                int lastBin, double effectiveDraws)
{
    if (draws.empty()) throw std::invalid_argument("stepProbability: no draws");
    if (!(limit >= 0.0) || !std::isfinite(limit))
        throw std::invalid_argument("stepProbability: the limit must be finite and 0 m or more");
    if (firstBin < 0 || firstBin >= lastBin || lastBin >= kBins)
        throw std::invalid_argument("stepProbability: no such bins");
    const auto n = static_cast<double>(draws.size());
    if (!(effectiveDraws >= 1.0 && effectiveDraws <= n))
        throw std::invalid_argument("stepProbability: more effective draws than draws, or none");

    const auto steps = std::count_if(draws.begin(), draws.end(), [&](const Heights& h) {
        return hasStep(h, limit, firstBin, lastBin);
    });
    const double p = static_cast<double>(steps) / n;
    const double never = 1.0 / (effectiveDraws + 2.0);  // p may not come closer to 0 or 1 than this
    const double shown = p > 0.0 && p < 1.0 ? p : never;
    return {p, std::sqrt(shown * (1.0 - shown) / effectiveDraws)};
}

double effectiveDraws(const TerrainEstimate& estimate)
{
    if (estimate.draws.empty()) throw std::invalid_argument("effectiveDraws: no draws");
    const auto n = static_cast<double>(estimate.draws.size());
    double least = n;
    for (std::size_t i = 0; i < kBins; ++i)
        if (estimate.origin[i] == Origin::Sampled) least = std::min(least, estimate.ess[i]);
    return std::max(least, 1.0);
}

std::array<StepProbability, kBins - 1> stepProbabilities(const TerrainEstimate& estimate,
                                                         double limit)
{
    const double effective = effectiveDraws(estimate);
    std::array<StepProbability, kBins - 1> result;
    for (int i = 0; i + 1 < kBins; ++i) {
        StepProbability& pair = result[static_cast<std::size_t>(i)];
        pair = stepProbability(estimate.draws, limit, i, i + 1, effective);
        pair.p = std::max(pair.p, unfeltStepRate(estimate, i + 1, i + 1));
    }
    return result;
}

StepProbability anyStep(const TerrainEstimate& estimate, double limit, int firstBin, int lastBin)
{
    StepProbability any =
        stepProbability(estimate.draws, limit, firstBin, lastBin, effectiveDraws(estimate));
    any.p = std::max(any.p, unfeltStepRate(estimate, firstBin, lastBin));
    return any;
}

}  // namespace terratact
