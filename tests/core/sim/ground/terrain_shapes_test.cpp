#include "core/sim/ground/terrain_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/faces.h"

namespace terratact {
namespace {

TEST(Sum, addsHeightsAndKeepsVerticalFaces)
{
    const TerrainProfile t = sum(stepTerrain(0.2, 1.0, 2.0), slopeTerrain(0.1, 0.5, 2.0));
    EXPECT_NEAR(tallestFace(t), 0.2, 1e-12);
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

TEST(DemoTerrain, hasAStepAtTheStatedPlace)
{
    const TerrainProfile t = demoTerrain();
    EXPECT_NEAR(t.heightAt(kDemoStep) - t.heightAt(kDemoStep - 1e-9), 0.24, 1e-6);
}

}  // namespace
}  // namespace terratact
