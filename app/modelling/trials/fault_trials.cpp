#include "app/modelling/trials/fault_trials.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "app/runtime/parallel.h"
#include "app/runtime/progress.h"
#include "core/infer/verdict/verdict.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

std::vector<WatchedLine> driveOne(const FaultTrial& trial, const RobotModel& robot,
                                  const TerrainProfile& ground, std::size_t k)
{
    std::seed_seq seed{trial.grounds.seed, static_cast<std::uint64_t>(k)};
    std::mt19937_64 rng(seed);
    WatchedStyle style;
    style.flippers = randomDriveStyle(rng);
    style.spacing = trial.spacing;
    style.comesBack = trial.comesBack;
    return driveWithTelemetry(robot, ground, style, rng());
}

FaultDrives soundDrives(const std::vector<TerrainProfile>& grounds, const FaultTrial& trial,
                        const RobotModel& robot)
{
    const auto wanted = static_cast<std::size_t>(trial.drives);
    FaultDrives found;
    Progress progress("drive", trial.drives);
    for (std::size_t next = 0; found.drives.size() < wanted && next < grounds.size();) {
        WatchedDrives drives(std::min(wanted - found.drives.size(), grounds.size() - next));
        parallelFor(static_cast<int>(drives.size()), [&](int n) {
            const std::size_t k = next + static_cast<std::size_t>(n);
            drives[k - next] = driveOne(trial, robot, grounds[k], k);
        });
        next += drives.size();
        for (std::vector<WatchedLine>& drive : drives) {
            const bool isWhole = !trial.comesBack || wayBack(drive) >= kMinWayBack;
            found.leftOut += isWhole ? 0 : 1;
            if (!isWhole) continue;
            found.drives.push_back(std::move(drive));
            progress.tick();
        }
    }
    return found;
}

void judgeScenes(const std::vector<WatchedScene>& watched, const FaultTrial& trial,
                 const EstimatorBundle& bundle, FaultCounts& counts)
{
    std::vector<Scene> scenes;
    scenes.reserve(watched.size());
    for (const WatchedScene& scene : watched) scenes.push_back(scene.scene);
    auto estimates = estimateScenes(scenes, bundle, trial.settings, 0.0);
    counts.contradicting += checkEstimates(scenes, bundle.robot, estimates);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const auto& estimate = estimates[k].estimate;
        ++counts.scenes;
        counts.suspects += watched[k].isSuspect ? 1 : 0;
        const bool isDoubted =
            watched[k].isSuspect || !estimate
            || !verdictOf(*estimate, watched[k].measurement, {}, kStepLimit).withheldFor.empty();
        counts.doubted += isDoubted ? 1 : 0;
        if (!estimate) continue;
        const auto errors = binErrors(k, scenes[k], "local", *estimate);
        counts.errors.insert(counts.errors.end(), errors.begin(), errors.end());
        if (!isDoubted)
            counts.trustedErrors.insert(counts.trustedErrors.end(), errors.begin(), errors.end());
    }
}

/// Returns the result of SensorWatch for every drive with the fault.
std::vector<WatchedFault> watchDrives(std::string_view fault, const RobotModel& robot,
                                      const WatchedDrives& drives)
{
    std::vector<WatchedFault> watched(drives.size());
    parallelFor(static_cast<int>(drives.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        watched[k] = watchFault(drives[k], robot, fault, k);
    });
    return watched;
}

}  // namespace

Result<FaultDrives> driveForFaults(const RobotModel& robot, const FaultTrial& trial)
{
    const std::size_t most = static_cast<std::size_t>(trial.drives) * (trial.comesBack ? 2 : 1);
    const auto grounds = drivenGrounds(trial.grounds, most);
    if (!grounds) return grounds.error();
    FaultDrives found = soundDrives(*grounds, trial, robot);
    if (found.drives.empty())
        return Error{"no drive came back over its ground: try other ground", 0};
    return found;
}

FaultCounts tryFault(const TriedFault& fault, const FaultTrial& trial,
                     const EstimatorBundle& bundle, const WatchedDrives& drives)
{
    FaultCounts counts;
    counts.drives = drives.size();
    std::vector<WatchedScene> scenes;
    for (const WatchedFault& drive : watchDrives(fault.fault, bundle.robot, drives)) {
        scenes.insert(scenes.end(), drive.scenes.begin(), drive.scenes.end());
        if (!drive.noticed) continue;
        counts.seconds.push_back(*drive.noticed);
        counts.scenesUntil.push_back(static_cast<double>(drive.scenesUntilNoticed));
    }
    judgeScenes(scenes, trial, bundle, counts);
    return counts;
}

double noticedPercent(std::string_view fault, const RobotModel& robot, const WatchedDrives& drives)
{
    const auto watched = watchDrives(fault, robot, drives);
    const auto noticed = std::ranges::count_if(
        watched, [](const WatchedFault& drive) { return drive.noticed.has_value(); });
    return sharePercent(static_cast<std::size_t>(noticed), drives.size());
}

double sharePercent(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::optional<double> medianOfDrives(std::vector<double> values, std::size_t drives)
{
    if (values.empty() || 2 * values.size() < drives) return std::nullopt;
    values.resize(drives, std::numeric_limits<double>::infinity());
    std::ranges::sort(values);
    return values[(drives - 1) / 2];
}

bool harms(const FaultCounts& fault, const FaultCounts& sound)
{
    const ErrorStatistics with = statistics(fault.errors), without = statistics(sound.errors);
    return with.mean > without.mean + 0.005 || with.coverage < without.coverage - 0.10;
}

bool isFlagged(const FaultCounts& fault)
{
    return sharePercent(fault.doubted, fault.scenes) >= 90.0
        || sharePercent(fault.seconds.size(), fault.drives) >= 90.0;
}

}  // namespace terratact
