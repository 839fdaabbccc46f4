#include "core/infer/estimate/hazards.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/base/random_unit.h"
#include "core/infer/estimate/quantile.h"

namespace terratact {
namespace {

// separates these random numbers from the sampler's
constexpr std::uint64_t kSeedOffset = 0x9E3779B97F4A7C15ULL;

bool isUnfelt(Touch touch)
{
    return touch == Touch::Bounded || touch == Touch::NotFelt;
}

/// Returns the draws in which a hazard begins: exactly ⌈rate · n⌉ of n, in random places.
std::vector<bool> chosenDraws(std::size_t n, double rate, std::mt19937_64& rng)
{
    const auto count = static_cast<std::size_t>(std::ceil(rate * static_cast<double>(n) - 1e-9));
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<bool> chosen(n, false);
    for (std::size_t k = 0; k < std::min(count, n); ++k) {
        const std::size_t other = k + static_cast<std::size_t>(rng() % (n - k));
        std::swap(order[k], order[other]);
        chosen[order[k]] = true;
    }
    return chosen;
}

double hazardOffset(Touch touch, std::mt19937_64& rng)
{
    const double size =
        kSmallestHazard * std::pow(kLargestHazard / kSmallestHazard, randomUnit(rng));
    const bool isWall = randomUnit(rng) < 0.5 && touch == Touch::NotFelt;
    return isWall ? size : -size;
}

void summarise(TerrainEstimate& estimate, std::size_t bin, PolledWork& work)
{
    std::vector<double> heights;
    heights.reserve(estimate.draws.size());
    for (const Heights& draw : estimate.draws) heights.push_back(draw[bin]);
    work.done(static_cast<long>(4 * heights.size()));
    std::sort(heights.begin(), heights.end());
    const auto n = static_cast<double>(heights.size());
    const double mean = std::accumulate(heights.begin(), heights.end(), 0.0) / n;
    double squares = 0.0;
    for (const double height : heights) squares += (height - mean) * (height - mean);
    estimate.mean[bin] = mean;
    estimate.sd[bin] = std::sqrt(squares / n);
    estimate.q10[bin] = quantileOfSorted(heights, 0.1);
    estimate.q90[bin] = quantileOfSorted(heights, 0.9);
}

}  // namespace

void addHazards(TerrainEstimate& estimate, double rate, const Poll& poll)
{
    if (!(rate >= 0.0 && rate <= 1.0))
        throw std::invalid_argument("the rate of hazards must be 0 to 1 per bin");
    if (rate == 0.0 || estimate.draws.empty()) return;
    PolledWork work(poll);
    std::mt19937_64 rng(estimate.settings.seed ^ kSeedOffset);
    std::vector<double> offset(estimate.draws.size(), 0.0);
    for (auto i = static_cast<std::size_t>(kFirstAhead); i < kBins; ++i) {
        const Touch touch = estimate.touch[i];
        if (!isUnfelt(touch)) {
            std::fill(offset.begin(), offset.end(), 0.0);
            continue;
        }
        const std::vector<bool> begins = chosenDraws(offset.size(), rate, rng);
        for (std::size_t d = 0; d < offset.size(); ++d) {
            work.done();
            if (begins[d]) offset[d] += hazardOffset(touch, rng);
            double& height = estimate.draws[d][i];
            if (offset[d] != 0.0)
                height = std::min(height + offset[d], std::max(height, estimate.ceiling[i]));
        }
        summarise(estimate, i, work);
    }
}

double unfeltStepRate(const TerrainEstimate& estimate, int firstBin, int lastBin)
{
    double without = 1.0;
    for (int bin = std::max(firstBin, kFirstAhead); bin <= lastBin; ++bin) {
        const Touch touch = estimate.touch[static_cast<std::size_t>(bin)];
        if (!isFeltThrough(touch) && touch != Touch::Unrecorded)
            without *= 1.0 - estimate.settings.hazardRate;
    }
    return 1.0 - without;
}

}  // namespace terratact
