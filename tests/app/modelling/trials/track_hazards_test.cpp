#include "app/modelling/trials/track_hazards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/robot/robot_model.h"

namespace terratact {
namespace {

const RobotModel& robot()
{
    static const RobotModel model =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    return model;
}

/// Returns a scene of level ground, with a step up at the bin `step` on the left.
TwoTrackScene sceneWith(int step)
{
    TwoTrackScene scene;
    for (OptionalHeights& truth : scene.truth) truth.fill(0.0);
    for (auto bin = static_cast<std::size_t>(step); bin < kBins; ++bin) scene.truth[0][bin] = 0.3;
    return scene;
}

/// Returns an estimate of level ground that is felt up to the last bin.
TwoTrackEstimate levelEstimate()
{
    TwoTrackEstimate estimate;
    for (TerrainEstimate& side : estimate.side) {
        side.settings.hazardRate = 0.0;
        side.ess.fill(400.0);
        side.ceiling.fill(0.5);
        side.touch.fill(Touch::Felt);
        side.feltTo = binEnd(kBins - 1);
        side.draws.assign(400, Heights{});
    }
    return estimate;
}

TrackHazardLine counted(const TwoTrackScene& scene, const TwoTrackEstimate& estimate)
{
    TrackHazardLine line;
    countScene(scene, robot(), estimate, 0.1, line);
    return line;
}

TEST(TrackHazards, clearIsFalseIfOneSideHasAStep)
{
    const TrackHazardLine line = counted(sceneWith(8), levelEstimate());
    EXPECT_EQ(line.robot.scenes, 1U);
    EXPECT_EQ(line.robot.clear, 1U);
    EXPECT_EQ(line.robot.withStep, 1U);
    EXPECT_EQ(line.robot.falseClear, 1U);
    EXPECT_EQ(line.robot.flat, 0U) << "the left is not flat";
    EXPECT_EQ(line.sides.scenes, 2U);
    EXPECT_EQ(line.sides.clear, 2U);
    EXPECT_EQ(line.sides.withStep, 1U);
    EXPECT_EQ(line.sides.falseClear, 1U);
    EXPECT_EQ(line.sides.flat, 1U);
}

TEST(TrackHazards, aStepBeyondTheHorizonIsOverlooked)
{
    TwoTrackEstimate estimate = levelEstimate();
    for (TerrainEstimate& side : estimate.side) {
        side.touch[10] = side.touch[9] = Touch::NotFelt;
        side.ceiling[10] = side.ceiling[9] = std::numeric_limits<double>::infinity();
        side.feltTo = binEnd(8);
    }
    const TrackHazardLine line = counted(sceneWith(10), estimate);
    EXPECT_EQ(line.robot.clear, 1U);
    EXPECT_EQ(line.robot.falseClear, 0U);
    EXPECT_EQ(line.robot.overlooked, 1U);
}

TEST(TrackHazards, levelGroundIsFlatOnBothSides)
{
    const TrackHazardLine line = counted(sceneWith(kBins), levelEstimate());
    EXPECT_EQ(line.robot.flat, 1U);
    EXPECT_EQ(line.robot.flatClear, 1U);
    EXPECT_EQ(line.robot.withStep, 0U);
    EXPECT_EQ(line.robot.feltBins, 2U * kBins);
}

TEST(TrackHazards, aHazardOnOneSideLeavesTheOtherLevel)
{
    std::mt19937_64 rng(4);
    bool fell = false;
    for (const TwoTrackScene& scene : driveTracksTowards(robot(), kHazardGrounds[0], Hazard::Drop,
                                                         false, PressStyle::Console, rng)) {
        const Heights left = knownHeights(scene.truth[0]), right = knownHeights(scene.truth[1]);
        const double leftDrop = left[6] - left[10], rightDrop = right[6] - right[10];
        if (std::abs(scene.s.roll) > 0.05) continue;  // one track is over the edge
        EXPECT_LT(std::min(leftDrop, rightDrop), 0.1);
        fell = fell || std::max(leftDrop, rightDrop) > 0.14;
    }
    EXPECT_TRUE(fell);
}

TEST(TrackHazards, tableSumsTheRobotAndItsSides)
{
    TrackHazardLine line = counted(sceneWith(8), levelEstimate());
    line.ground = "level";
    line.hazard = "wall, one side";
    const std::string table = trackHazardTable(std::vector{line, line});
    EXPECT_NE(table.find("\nlevel, wall, one side               1      1       0      1      1"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("\nall                                 2      2       0      2      2"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("\nall, each side                      4      2       0      4      2"),
              std::string::npos)
        << table;
}

}  // namespace
}  // namespace terratact
