#include "core/terrain/terrain_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"

namespace terratact {
namespace {

TEST(TerrainProfile, goesOnLevelBeyondItsEnds)
{
    const TerrainProfile t({{1.0, 0.3}, {2.0, 0.5}});
    EXPECT_DOUBLE_EQ(t.heightAt(-5.0), 0.3);
    EXPECT_DOUBLE_EQ(t.heightAt(9.0), 0.5);
    EXPECT_DOUBLE_EQ(t.meanOver(0.0, 1.0), 0.3);
    EXPECT_DOUBLE_EQ(t.meanOver(3.0, 4.0), 0.5);
    EXPECT_DOUBLE_EQ(t.meanOver(0.0, 3.0), (0.3 + 0.4 + 0.5) / 3.0);
}

TEST(TerrainProfile, hasTheUpperHeightAtAStep)
{
    const TerrainProfile up = stepTerrain(0.2, 1.0, 3.0);
    EXPECT_DOUBLE_EQ(up.heightAt(1.0), 0.2);
    EXPECT_DOUBLE_EQ(stepTerrain(-0.2, 1.0, 3.0).heightAt(1.0), 0.0);
    EXPECT_NEAR(up.meanOver(0.95, 1.05), 0.1, 1e-15);
}

TEST(TerrainProfile, meanIsTheIntegralOfItsLine)
{
    std::mt19937_64 rng(7);
    const TerrainProfile t = randomVariedTerrain(rng);
    for (double a = -0.5; a < 6.0; a += 0.173) {
        constexpr int kSteps = 20000;
        double sum = 0.0;
        for (int k = 0; k < kSteps; ++k) sum += t.heightAt(a + 0.1 * (k + 0.5) / kSteps);
        EXPECT_NEAR(t.meanOver(a, a + 0.1), sum / kSteps, 3e-5) << "from " << a;
    }
}

TEST(TerrainProfile, ofBlocksHasVerticalFaces)
{
    const TerrainProfile t = TerrainProfile::fromSamples({0.0, 0.4, 0.1}, 0.1, true);
    EXPECT_DOUBLE_EQ(t.heightAt(0.1), 0.4);
    EXPECT_DOUBLE_EQ(t.heightAt(0.149), 0.4);
    EXPECT_DOUBLE_EQ(t.heightAt(0.151), 0.1);
    EXPECT_NEAR(t.meanOver(0.05, 0.15), 0.4, 1e-12);
}

TEST(TerrainProfile, sampledKeepsEveryCornerAndTheSpacing)
{
    const TerrainProfile t = boxTerrain(0.28, 1.0, 0.5, 3.0);
    const auto line = t.sampled(0.503, 2.001, 0.01);
    EXPECT_DOUBLE_EQ(line.front().x, 0.503);
    EXPECT_DOUBLE_EQ(line.back().x, 2.001);
    for (std::size_t i = 1; i < line.size(); ++i) {
        EXPECT_LE(line[i].x - line[i - 1].x, 0.01 + 1e-9);
        EXPECT_LE(std::abs(line[i].z - line[i - 1].z), 0.01 + 1e-9);
    }
    const auto has = [&](Vec2 p) { return std::find(line.begin(), line.end(), p) != line.end(); };
    EXPECT_TRUE(has({1.0, 0.0}) && has({1.0, 0.28}));
}

TEST(TerrainProfile, refusesInvalidGround)
{
    EXPECT_THROW(TerrainProfile({}), std::invalid_argument);
    EXPECT_THROW(TerrainProfile({{1.0, 0.0}, {0.9, 0.0}}), std::invalid_argument);
    EXPECT_THROW(TerrainProfile({{0.0, std::nan("")}}), std::invalid_argument);
    EXPECT_THROW((void)flatTerrain(1.0).meanOver(0.5, 0.5), std::invalid_argument);
}

TEST(BinHeights, areMeansRelativeToTheImu)
{
    const Heights h = binHeights(stepTerrain(0.2, 3.0, 6.0), {2.6, 0.24});
    EXPECT_NEAR(h[3], -0.24, 1e-12);  // under the IMU
    EXPECT_NEAR(h[7], -0.14, 1e-12);  // bin 0.4: the step lies in its middle
    EXPECT_NEAR(h[8], -0.04, 1e-12);
}

}  // namespace
}  // namespace terratact
