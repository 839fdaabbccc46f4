#include "app/modelling/simulation/hazard_scenes.h"

#include <gtest/gtest.h>

#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr int kReach = 8;  // the bin at +0.5 m

std::vector<HazardScene> scenesOver(const HazardGround& ground, std::uint64_t seed = 3)
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    std::mt19937_64 rng(seed);
    return driveTowards(robot, ground, std::nullopt, PressStyle::Console, rng);
}

Heights heightsOf(const HazardScene& driven)
{
    Heights heights{};
    for (std::size_t i = 0; i < kBins; ++i) heights[i] = driven.scene.truth[i].value();
    return heights;
}

TEST(HazardScenes, flatGroundIsStraight)
{
    Heights slope{};
    for (std::size_t i = 0; i < kBins; ++i) slope[i] = 0.04 * static_cast<double>(i);
    EXPECT_TRUE(isFlatTo(slope, 0.10, kReach));
    slope[5] += 0.03;
    EXPECT_FALSE(isFlatTo(slope, 0.10, kReach));
    EXPECT_TRUE(isFlatTo(slope, 0.10, 4));
    Heights step{};
    step[8] = -0.15;
    EXPECT_FALSE(isFlatTo(step, 0.10, kReach));
    EXPECT_TRUE(isFlatTo(step, 0.10, 7));
}

TEST(HazardScenes, pressedGroundHasNoLongGap)
{
    const std::vector<double> close{-0.2, 0.27, 0.31, 0.35, 0.39, 0.43, 0.47, 0.51};
    EXPECT_TRUE(isPressedTo(close, kReach));
    EXPECT_FALSE(isPressedTo({0.27, 0.31, 0.39, 0.43, 0.47, 0.51}, kReach));
    EXPECT_FALSE(isPressedTo({0.27, 0.31, 0.35, 0.39, 0.43, 0.47}, kReach)) << "the reach";
    EXPECT_FALSE(isPressedTo({0.31, 0.35, 0.39, 0.43, 0.47, 0.51}, kReach)) << "the pivot";
    EXPECT_FALSE(isPressedTo({}, kReach));
}

TEST(HazardScenes, consolePressesOnLevelNotOnHardRoughGround)
{
    const auto level = scenesOver(kHazardGrounds[0]);
    ASSERT_EQ(level.size(), 25U);
    for (const HazardScene& driven : level) {
        EXPECT_TRUE(isFlatTo(heightsOf(driven), 0.10, kReach));
        EXPECT_TRUE(isPressedTo(driven.contacts, kReach));
    }
    for (const HazardScene& driven : scenesOver(kHazardGrounds[2])) {
        EXPECT_TRUE(isFlatTo(heightsOf(driven), 0.10, kReach));
        EXPECT_FALSE(isPressedTo(driven.contacts, kReach));
    }
}

TEST(HazardScenes, softGroundIsPressedDespiteRoughness)
{
    std::size_t pressed = 0, scenes = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const HazardScene& driven : scenesOver(kHazardGrounds[4], seed)) {
            pressed += isPressedTo(driven.contacts, kReach) ? 1U : 0U;
            ++scenes;
        }
    EXPECT_GT(pressed, scenes / 3);
}

TEST(HazardScenes, aDriveWithItsWayMeetsTheHazard)
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    std::mt19937_64 rng(3);
    const DriveLines drive =
        driveTracksAlong(robot, kHazardGrounds[0], Hazard::Drop, true, PressStyle::Console, rng);
    int near = 0, far = 0, steps = 0;
    std::size_t onTheWay = 0;
    for (const DriveLine& line : drive.lines) {
        onTheWay += line.isScene ? 0U : 1U;
        if (!line.isScene) continue;
        if (!isNear(line.line)) {
            ++far;
            continue;
        }
        ++near;
        steps += hasStep(knownHeights(line.truth[0]), 0.10, kFirstAhead, kReach) ? 1 : 0;
    }
    EXPECT_GT(onTheWay, drive.lines.size() / 2);
    EXPECT_GT(near, 5);
    EXPECT_GT(far, 2) << "the begin of the drive is not judged";
    EXPECT_GT(steps, 0) << "the last scenes see the drop";
    EXPECT_LT(steps, near) << "the first ones do not";
}

}  // namespace
}  // namespace terratact
