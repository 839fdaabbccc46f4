#include "core/sim/two_track_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/learn/data/ground_file.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/real_ground.h"

namespace terratact {
namespace {

TEST(TwoTrackDrive, onOnePlaneRecordsThePlanesScenes)
{
    const RobotModel robot = absolem();
    const TerrainProfile terrain = boxTerrain(0.2, 2.0, 1.0, 6.0);
    const std::vector<double> stops = stopsOver(terrain, 0.4);
    const DriveConditions exact{.noise = SensorNoise::none()};
    std::mt19937_64 rng(1);
    int skipped = 0;
    const auto plane = driveOver(robot, terrain, stops, "1", {}, exact, rng, skipped);
    const auto both = driveOver(robot, GroundLines(terrain), stops, "1", {}, exact, rng, skipped);
    ASSERT_EQ(plane.size(), both.size());
    EXPECT_EQ(skipped, 0);
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const TwoTrackScene expected = onBothSides(plane[i]);
        EXPECT_EQ(both[i].time, expected.time);
        EXPECT_NEAR(both[i].s.pitch, expected.s.pitch, 1e-5);
        EXPECT_NEAR(both[i].s.flippers[1], expected.s.flippers[1], 1e-5);
        EXPECT_NEAR(*both[i].s.forces[1][5], *expected.s.forces[1][5], 0.01);
        for (std::size_t bin = 0; bin < kBins; ++bin)
            EXPECT_NEAR(*both[i].truth[1][bin], *expected.truth[1][bin], 1e-4);
    }
}

TEST(TwoTrackDrive, readsRollWithNoise)
{
    const RobotModel robot = absolem();
    std::vector<GroundLine> lines;
    for (const double y : groundYs(robot))
        lines.push_back({y, TerrainProfile({{0, y * 0.1}, {400, y * 0.1}})});
    const GroundLines slope(lines);
    std::mt19937_64 rng(2);
    int skipped = 0;
    const auto scenes = driveOver(robot, slope, stopsOver(slope, 1.0), "1", {}, {}, rng, skipped);
    ASSERT_GT(scenes.size(), 300U);
    double sum = 0.0, squares = 0.0;
    for (const TwoTrackScene& scene : scenes) {
        sum += scene.s.roll;
        squares += std::pow(scene.s.roll - std::asin(0.1), 2.0);
    }
    const auto count = static_cast<double>(scenes.size());
    EXPECT_NEAR(sum / count, std::asin(0.1), 0.003);
    EXPECT_NEAR(std::sqrt(squares / count), SensorNoise{}.pitch, 0.0015);
}

TEST(TwoTrackDrive, restsOnRealGround)
{
    const auto path = realGround("track_pairs.csv");
    if (!path) GTEST_SKIP() << "TERRATACT_TERRAIN names no folder";
    const auto file = readGrounds(*path, 0.1, false);
    ASSERT_TRUE(file) << file.error().text;
    const RobotModel robot = absolem();
    std::mt19937_64 rng(4);
    int skipped = 0, rested = 0, rolled = 0;
    for (std::size_t k = 0; k < file->grounds.size(); k += 8) {
        const GroundLines& ground = file->grounds[k];
        const auto scenes = driveOver(robot, ground, stopsOver(ground, 0.4), "1",
                                      randomDriveStyle(rng), {}, rng, skipped);
        for (const TwoTrackScene& scene : scenes) rolled += std::abs(scene.s.roll) > 0.1;
        rested += static_cast<int>(scenes.size());
    }
    EXPECT_GT(rested, 200);
    EXPECT_LT(skipped, rested / 10);
    EXPECT_GT(rolled, rested / 6);  // a plane's robot does not roll
}

TEST(TwoTrackDrive, refusesConditionsItDoesNotKnow)
{
    const GroundLines flat(flatTerrain(6.0));
    std::mt19937_64 rng(3);
    int skipped = 0;
    EXPECT_THROW((void)driveOver(absolem(), flat, {3.0}, "1", {}, {.slide = 0.05}, rng, skipped),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
