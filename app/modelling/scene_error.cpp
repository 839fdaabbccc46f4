#include "app/modelling/scene_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace terratact {

std::optional<SceneError> sceneError(const TwoTrackEstimate& estimate,
                                     const std::array<OptionalHeights, 2>& truth)
{
    const std::size_t sides = estimate.onePlane && truth[0] == truth[1] ? 1 : 2;
    std::vector<double> errors;
    for (std::size_t side = 0; side < sides; ++side)
        for (std::size_t i = 0; i < kBins; ++i)
            if (const std::optional<double>& height = truth.at(side)[i])
                errors.push_back(std::abs(estimate.side.at(side).height[i] - *height));
    if (errors.empty()) return std::nullopt;
    std::ranges::sort(errors);
    const std::size_t middle = errors.size() / 2;
    const double upper = errors[middle];
    return SceneError{.bins = static_cast<int>(errors.size()),
                      .median = errors.size() % 2 == 1 ? upper : 0.5 * (errors[middle - 1] + upper),
                      .mean = std::accumulate(errors.begin(), errors.end(), 0.0)
                            / static_cast<double>(errors.size()),
                      .largest = errors.back()};
}

int knownHeights(const std::array<OptionalHeights, 2>& truth)
{
    int known = 0;
    for (std::size_t side = 0; side < (truth[0] == truth[1] ? 1U : 2U); ++side)
        for (const std::optional<double>& height : truth.at(side)) known += height ? 1 : 0;
    return known;
}

}  // namespace terratact
