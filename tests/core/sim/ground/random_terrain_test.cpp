#include "core/sim/ground/random_terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/faces.h"

namespace terratact {
namespace {

TEST(BoxTerrain, hasOneOfThePapersTwoHeightsAndBothOccur)
{
    std::mt19937_64 rng(1);
    int low = 0;
    int high = 0;
    for (int run = 0; run < 28; ++run) {
        const double face = tallestFace(randomBoxTerrain(rng));
        low += std::abs(face - 0.20) < 1e-12 ? 1 : 0;
        high += std::abs(face - 0.28) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(low + high, 28);
    EXPECT_GT(low, 5);
    EXPECT_GT(high, 5);
}

std::vector<TerrainProfile> manyVaried(int count)
{
    std::mt19937_64 rng(2);
    std::vector<TerrainProfile> terrains;
    for (int run = 0; run < count; ++run) terrains.push_back(randomVariedTerrain(rng));
    return terrains;
}

// The order of the draws does not depend on the compiler: g++ and clang give this number.
TEST(VariedTerrain, isTheSameForASeedWithEveryCompiler)
{
    double sum = 0.0;
    for (const TerrainProfile& terrain : manyVaried(100))
        for (int k = 0; k < 50; ++k) sum += terrain.heightAt(0.1 * k);
    EXPECT_NEAR(sum, -436.290144465, 1e-6);
}

TEST(VariedTerrain, keepsItsFacesWithinTheStatedHeights)
{
    for (const TerrainProfile& t : manyVaried(300)) {
        // A hole's far side may rise by 1.3 times a block's 0.35 m.
        EXPECT_LE(tallestFace(t), 0.46);
        EXPECT_GE(t.end() - t.begin(), kRandomTerrainLength - 0.11);
    }
}

TEST(VariedTerrain, halfIsAMapAndMostOthersHaveFaces)
{
    int maps = 0;
    int faces = 0;
    for (const TerrainProfile& t : manyVaried(400)) {
        const bool map = std::abs(t.points()[1].x - t.points()[0].x - kBinWidth) < 1e-9
                      && std::abs(t.points()[0].x - 0.5 * kBinWidth) < 1e-9;
        maps += map ? 1 : 0;
        faces += tallestFace(t) > 0.02 ? 1 : 0;
        EXPECT_TRUE(!map || tallestFace(t) == 0.0);
    }
    EXPECT_NEAR(maps, 200, 40);
    EXPECT_GT(faces, 150);
}

TEST(VariedTerrain, isTheSameForTheSameSeed)
{
    std::mt19937_64 a(5), b(5);
    const TerrainProfile first = randomVariedTerrain(a);
    const TerrainProfile second = randomVariedTerrain(b);
    ASSERT_EQ(first.points().size(), second.points().size());
    for (std::size_t i = 0; i < first.points().size(); ++i)
        EXPECT_EQ(first.points()[i].z, second.points()[i].z);
}

/// Returns the variance of many roughness profiles at one place.
double varianceAt(double x, double gn0)
{
    std::mt19937_64 rng(3);
    double square = 0.0;
    constexpr int kProfiles = 3000;
    for (int k = 0; k < kProfiles; ++k) {
        const double z = isoRoughness(gn0, 1.0, rng).heightAt(x);
        square += z * z / kProfiles;
    }
    return square;
}

TEST(IsoRoughness, hasTheVarianceOfItsSpectrum)
{
    const double expected = 1024e-6 * 0.01 * (1.0 / 0.25 - 1.0 / 10.0);
    EXPECT_NEAR(varianceAt(0.5, 1024e-6) / expected, 1.0, 0.1);
}

TEST(IsoRoughness, fallsBySixDecibelPerOctaveOfWaveNumber)
{
    // Share of the variance above n = 1 / m: (1/1 − 1/10) / (1/0.25 − 1/10) = 0.231. A difference
    // over half a metre scales a wave n by 4 sin²(π n / 2).
    std::mt19937_64 rng(4);
    const double gn0 = 4096e-6;
    double expected = 0.0;
    for (double n = 0.25; n < 10.0; n += 1e-4)
        expected +=
            1e-4 * gn0 * 0.01 / (n * n) * 4.0 * std::pow(std::sin(std::numbers::pi * n * 0.5), 2.0);
    double measured = 0.0;
    constexpr int kProfiles = 3000;
    for (int k = 0; k < kProfiles; ++k) {
        const TerrainProfile t = isoRoughness(gn0, 1.0, rng);
        measured += std::pow(t.heightAt(0.8) - t.heightAt(0.3), 2.0) / kProfiles;
    }
    EXPECT_NEAR(measured / expected, 1.0, 0.1);
}

TEST(ElevationMap, holdsTheMeansOfItsCells)
{
    const TerrainProfile map = asElevationMap(stepTerrain(0.2, 0.55, 1.0), 0.1);
    ASSERT_EQ(map.points().size(), 10u);
    EXPECT_NEAR(map.points()[4].z, 0.0, 1e-12);
    EXPECT_NEAR(map.points()[5].z, 0.1, 1e-12);
    EXPECT_NEAR(map.points()[6].z, 0.2, 1e-12);
    EXPECT_NEAR(map.points()[0].x, 0.05, 1e-12);
}

}  // namespace
}  // namespace terratact
