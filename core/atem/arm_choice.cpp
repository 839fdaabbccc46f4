#include "core/atem/arm_choice.h"

#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

/// Returns true if the arm can measure the bin's height and nothing has measured it yet.
bool isOpen(const TerrainEstimate& estimate, const RobotModel& robot, int bin)
{
    return robot.armSd > 0.0 && robot.armReaches(bin)
        && estimate.origin[static_cast<std::size_t>(bin)] == Origin::Sampled;
}

bool hasOpenBin(const TerrainEstimate& estimate, const RobotModel& robot)
{
    for (int bin = 0; bin < kBins; ++bin)
        if (isOpen(estimate, robot, bin)) return true;
    return false;
}

}  // namespace

std::optional<int> proposeProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    std::optional<int> best;
    double bestSd = estimate.settings.probeAbove;
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        if (isOpen(estimate, robot, bin) && estimate.sd[i] > bestSd) {
            best = bin;
            bestSd = estimate.sd[i];
        }
    }
    return best;
}

std::optional<int> chooseProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    constexpr double kAnyStep = 0.1;  // [m]; the rule by variance does not use it
    const std::optional<int> widest = proposeProbe(estimate, robot);
    if (!widest || isOfPaper(estimate.settings.method) || estimate.draws.empty()) return widest;
    const auto best = bestProbe(estimate, robot, robot.armSd, kAnyStep);
    return best ? best->bin : widest;
}

ProbeAdvice adviseProbe(const TerrainEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll)
{
    ProbeAdvice advice;
    advice.stepLimit = stepLimit;
    advice.bin = proposeProbe(estimate, robot);
    if (estimate.draws.empty()) return advice;
    advice.before = uncertainty(estimate, stepLimit, kFirstAhead, poll);
    if (!hasOpenBin(estimate, robot)) return advice;
    advice.gains = probeGains(estimate, robot, robot.armSd, stepLimit, kFirstAhead, poll);
    std::erase_if(advice.gains, [&](const ProbeGain& gain) {
        return estimate.origin[static_cast<std::size_t>(gain.bin)] != Origin::Sampled;
    });
    if (advice.bin && !isOfPaper(estimate.settings.method)) advice.bin = advice.gains.front().bin;
    return advice;
}

}  // namespace terratact
