#include "core/sim/drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

std::vector<Scene> driveOnce(const SensorNoise& noise, unsigned seed)
{
    std::mt19937_64 rng(seed);
    int skipped = 0;
    const TerrainProfile terrain = boxTerrain(0.2, 2.0, 1.0, 6.0);
    return driveOver(absolem(), terrain, stopsOver(terrain, 0.25), "7", {}, {.noise = noise}, rng,
                     skipped);
}

TEST(Drive, measuresASceneAtEveryStop)
{
    const auto scenes = driveOnce(SensorNoise::none(), 1);
    ASSERT_GT(scenes.size(), 15U);
    for (const Scene& scene : scenes) {
        EXPECT_EQ(scene.run, "7");
        for (const auto& h : scene.truth) EXPECT_TRUE(h.has_value());
        for (const auto& f : scene.s.force) EXPECT_GE(f.value(), 0.0);
    }
    EXPECT_LT(scenes.front().time, scenes.back().time);
}

TEST(Drive, repeatsForASeedAndNoiseIsSeeded)
{
    EXPECT_EQ(driveOnce({}, 3), driveOnce({}, 3));
    EXPECT_NE(driveOnce({}, 3), driveOnce({}, 4));
    EXPECT_EQ(driveOnce(SensorNoise::none(), 3), driveOnce(SensorNoise::none(), 4));
}

TEST(SoftGround, isSoftWithinItsBounds)
{
    std::mt19937_64 rng(5);
    for (int k = 0; k < 100; ++k) {
        const GroundOptions ground = randomSoftGround(rng);
        EXPECT_GE(ground.softLayer, 0.012);
        EXPECT_LT(ground.softLayer, absolem().front.tipRadius);
        EXPECT_GE(ground.softStiffness, 60.0);
        EXPECT_LE(ground.softStiffness, 240.0);
    }
}

TEST(StopsOver, keepTheRobotAndItsBinsOnTheTerrain)
{
    const TerrainProfile terrain = flatTerrain(4.0);
    const auto stops = stopsOver(terrain, 0.1);
    EXPECT_GE(stops.front() - 0.59, terrain.begin());
    EXPECT_LE(stops.back() + 0.75, terrain.end());
    EXPECT_EQ(stopsOver(flatTerrain(1.0), 0.1),
              std::vector<double>{0.3});  // bin −0.3 on the first point
}

}  // namespace
}  // namespace terratact
