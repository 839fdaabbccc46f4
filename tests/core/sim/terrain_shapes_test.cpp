#include "core/sim/terrain_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

double faceOf(const TerrainProfile& t)
{
    double tallest = 0.0;
    for (std::size_t i = 1; i < t.points().size(); ++i)
        if (t.points()[i].x == t.points()[i - 1].x)
            tallest = std::max(tallest, std::abs(t.points()[i].z - t.points()[i - 1].z));
    return tallest;
}

TEST(BoxDrive, hasOneOfThePapersTwoHeightsAndBothOccur)
{
    std::mt19937_64 rng(1);
    int low = 0;
    int high = 0;
    for (int run = 0; run < 28; ++run) {
        const double face = faceOf(randomBoxDrive(rng));
        low += std::abs(face - 0.20) < 1e-12 ? 1 : 0;
        high += std::abs(face - 0.28) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(low + high, 28);
    EXPECT_GT(low, 5);
    EXPECT_GT(high, 5);
}

TEST(VariedDrive, keepsItsFacesWithinTheStatedHeights)
{
    std::mt19937_64 rng(2);
    for (int run = 0; run < 200; ++run) {
        const TerrainProfile t = randomVariedDrive(rng);
        EXPECT_LE(faceOf(t), 0.36) << run;
        EXPECT_GE(t.end(), 6.0) << run;
    }
}

TEST(Sum, addsHeightsAndKeepsVerticalFaces)
{
    const TerrainProfile t = sum(stepTerrain(0.2, 1.0, 2.0), slopeTerrain(0.1, 0.5, 2.0));
    EXPECT_NEAR(faceOf(t), 0.2, 1e-12);
    EXPECT_NEAR(t.heightAt(1.5), 0.2 + std::tan(0.1), 1e-12);
}

TEST(RoughTerrain, hasItsStandardDeviationAndCorrelation)
{
    std::mt19937_64 rng(3);
    const TerrainProfile t = roughTerrain(0.02, 0.1, 400.0, rng);
    double sum = 0.0;
    double square = 0.0;
    double lagged = 0.0;
    const auto& p = t.points();
    for (const Vec2 q : p) sum += q.z;
    const double mean = sum / static_cast<double>(p.size());
    for (std::size_t i = 0; i + 10 < p.size(); ++i) {
        square += (p[i].z - mean) * (p[i].z - mean);
        lagged += (p[i].z - mean) * (p[i + 10].z - mean);
    }
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(p.size())), 0.02, 0.001);
    EXPECT_NEAR(lagged / square, std::exp(-1.0), 0.03);
}

TEST(DemoTerrain, hasAStepWhereItSays)
{
    const TerrainProfile t = demoTerrain();
    EXPECT_NEAR(t.heightAt(kDemoStep) - t.heightAt(kDemoStep - 1e-9), 0.24, 1e-6);
}

}  // namespace
}  // namespace terratact
