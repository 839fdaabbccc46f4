#include "core/infer/each_side.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/robot/side_plane.h"
#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

/// Returns how much higher than in the robot's middle plane each bin of a side lies [m].
Heights liftsOf(Side side, const RobotModel& robot, double roll)
{
    Heights lifts{};
    for (int bin = 0; bin < kBins; ++bin) {
        const double y = bin < kFirstFlipperBin ? robot.lateral.trackY : robot.lateral.flipperY;
        lifts[static_cast<std::size_t>(bin)] = signOf(side) * y * std::sin(roll);
    }
    return lifts;
}

void raise(TerrainEstimate& estimate, const Heights& lifts)
{
    const auto raised = [&](Heights& heights) {
        for (std::size_t i = 0; i < kBins; ++i) heights[i] += lifts[i];
    };
    for (Heights* heights :
         {&estimate.mean, &estimate.q10, &estimate.q90, &estimate.height, &estimate.ceiling})
        raised(*heights);
    for (Heights& draw : estimate.draws) raised(draw);
}

/// Returns a watch that reports a side's progress as one half of the whole.
Watch halfOf(const Watch& watch, Side side)
{
    Watch half = watch;
    if (watch.progress)
        half.progress = [&watch, from = side == Side::Left ? 0.0 : 0.5](double share) {
            watch.progress(from + 0.5 * share);
        };
    return half;
}

TerrainEstimate estimateSide(Side side, const TwoTrackReadings& s, std::span<const ArmReading> arm,
                             const RobotModel& robot, const Models& models,
                             const Settings& settings, const Watch& watch)
{
    const Heights lifts = liftsOf(side, robot, s.roll);
    std::vector<ArmReading> readings(arm.begin(), arm.end());
    for (ArmReading& reading : readings)
        reading.height -= lifts[static_cast<std::size_t>(reading.bin)];
    Settings own = settings;
    own.seed += side == Side::Left ? 0 : 1;
    TerrainEstimate estimate =
        estimateTerrain(sideReadings(s, side), readings, robot, models, own, halfOf(watch, side));
    raise(estimate, lifts);
    estimate.settings.seed = settings.seed;
    return estimate;
}

}  // namespace

TwoTrackEstimate estimateEachSide(const TwoTrackReadings& s, const SideArms& arms,
                                  const RobotModel& robot, const Models& models,
                                  const Settings& settings, const Watch& watch)
{
    TwoTrackEstimate estimate{
        .side = {estimateSide(Side::Left, s, arms[0], robot, models, settings, watch),
                 estimateSide(Side::Right, s, arms[1], robot, models, settings, watch)},
        .onePlane = false};
    const std::size_t count =
        std::min(estimate.side[0].draws.size(), estimate.side[1].draws.size());
    for (TerrainEstimate& side : estimate.side) side.draws.resize(count);
    return estimate;
}

}  // namespace terratact
