#include "core/atem/arm_choice.h"

namespace terratact {

std::optional<int> proposeProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    std::optional<int> best;
    double bestSd = estimate.settings.probeAbove;
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const bool candidate = estimate.origin[i] == Origin::Sampled && robot.armReaches(bin);
        if (candidate && estimate.sd[i] > bestSd) {
            best = bin;
            bestSd = estimate.sd[i];
        }
    }
    return best;
}

}  // namespace terratact
