#include "app/modelling/trials/probe_trials.h"

#include <algorithm>
#include <utility>

#include "app/runtime/parallel.h"
#include "core/atem/probe/arm_choice.h"
#include "core/atem/probe/probe_gain.h"

namespace terratact {
namespace {

bool wasRead(int bin, std::span<const ArmReading> read)
{
    return std::any_of(read.begin(), read.end(),
                       [bin](const ArmReading& r) { return r.bin == bin; });
}

/// Returns the unread bin with the largest gain of one kind.
std::optional<int> largestGain(const std::vector<ProbeGain>& gains,
                               std::span<const ArmReading> read, double ProbeGain::*kind)
{
    std::optional<ProbeGain> best;
    for (const ProbeGain& gain : gains)
        if (!wasRead(gain.bin, read) && (!best || gain.*kind > (*best).*kind)) best = gain;
    if (!best) return std::nullopt;
    return best->bin;
}

ProbeLimits limitsOf(const RobotModel& robot, const Settings& settings)
{
    return {.armSd = robot.armSd, .sdLimit = settings.probeAbove, .seed = settings.seed};
}

}  // namespace

std::vector<NamedRule> probeRules(const RobotModel& robot, double stepLimit)
{
    const auto byGain = [&robot, stepLimit](double ProbeGain::*kind) -> ProbeRule {
        return [&robot, stepLimit, kind](const TerrainEstimate& estimate,
                                         std::span<const ArmReading> read) {
            return largestGain(probeGains(estimate, robot, robot.armSd, stepLimit), read, kind);
        };
    };
    return {{"sd", [&robot](const TerrainEstimate& estimate,
                            std::span<const ArmReading>) { return proposeProbe(estimate, robot); }},
            {"variance", byGain(&ProbeGain::varianceReduction)},
            {"step", byGain(&ProbeGain::entropyReduction)}};
}

std::vector<ProbeRun> tryProbeRules(const std::string& label, std::span<const Scene> scenes,
                                    const std::vector<SceneEstimate>& estimates, std::size_t first,
                                    const EstimatorBundle& bundle, const Settings& settings,
                                    double stepLimit, double seconds)
{
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        if (hasTruthAhead(scenes[k]) && estimates[k].estimate) chosen.push_back(k);
    const ProbeLimits limits = limitsOf(bundle.robot, settings);
    std::vector<ProbeRun> runs;
    for (const NamedRule& rule : probeRules(bundle.robot, stepLimit)) {
        std::vector<ProbeTrial> trials(chosen.size());
        parallelFor(static_cast<int>(chosen.size()), [&](int n) {
            const std::size_t k = chosen[static_cast<std::size_t>(n)];
            Settings own = settings;
            own.seed += first + k;
            const auto estimate = [&](const Scene& scene, std::span<const ArmReading> readings) {
                return estimateWith(scene, readings, bundle, own, seconds);
            };
            trials[static_cast<std::size_t>(n)] = tryProbes(
                first + k, scenes[k], *estimates[k].estimate, estimate, rule.choose, limits);
        });
        runs.push_back({label, rule.name, std::move(trials)});
    }
    return runs;
}

}  // namespace terratact
