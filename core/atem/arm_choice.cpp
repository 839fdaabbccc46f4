#include "core/atem/arm_choice.h"

#include "core/infer/obstacle.h"

namespace terratact {
namespace {

bool reachesOpenBin(const TerrainEstimate& estimate, const RobotModel& robot)
{
    if (!(robot.armSd > 0.0)) return false;  // it has no arm
    for (int bin = 0; bin < kBins; ++bin)
        if (robot.armReaches(bin)
            && estimate.origin[static_cast<std::size_t>(bin)] == Origin::Sampled)
            return true;
    return false;
}

}  // namespace

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

std::optional<int> chooseProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    constexpr double kAnyStep = 0.1;  // [m]; the rule by variance does not depend on it
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
    if (!reachesOpenBin(estimate, robot)) {
        advice.bin.reset();  // an arm that says nothing of a height
        return advice;
    }
    advice.gains = probeGains(estimate, robot, robot.armSd, stepLimit, kFirstAhead, poll);
    std::erase_if(advice.gains, [&](const ProbeGain& gain) {
        return estimate.origin[static_cast<std::size_t>(gain.bin)] != Origin::Sampled;
    });
    if (advice.bin && !isOfPaper(estimate.settings.method)) advice.bin = advice.gains.front().bin;
    return advice;
}

}  // namespace terratact
