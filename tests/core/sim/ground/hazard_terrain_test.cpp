#include "core/sim/ground/hazard_terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/infer/estimate/hazards.h"
#include "core/sim/ground/random_terrain.h"

namespace terratact {
namespace {

TEST(HazardTerrain, isLevelUpToTheHazard)
{
    for (const Hazard hazard : kHazards)
        for (unsigned seed = 0; seed < 20; ++seed) {
            std::mt19937_64 rng(seed);
            const TerrainProfile ground = randomHazardTerrain(hazard, 0.0, rng);
            EXPECT_EQ(ground.heightAt(kHazardBegin - 0.01), 0.0) << name(hazard);
            double lowest = 0.0, highest = 0.0;
            for (double x = kHazardBegin; x < kRandomTerrainLength; x += 0.005) {
                lowest = std::min(lowest, ground.heightAt(x));
                highest = std::max(highest, ground.heightAt(x));
            }
            EXPECT_GE(highest - lowest, kSmallestHazard - 1e-9) << name(hazard) << seed;
            EXPECT_LE(highest - lowest, kLargestHazard + 0.4) << name(hazard) << seed;
            EXPECT_GE(ground.end(), kRandomTerrainLength);
        }
}

TEST(HazardTerrain, isTheSameForTheSameSeed)
{
    for (const Hazard hazard : kHazards) {
        std::mt19937_64 a(3), b(3);
        EXPECT_EQ(randomHazardTerrain(hazard, 16e-6, a).points(),
                  randomHazardTerrain(hazard, 16e-6, b).points());
    }
}

TEST(HazardTerrain, namesAreUnique)
{
    std::set<std::string_view> names;
    for (const Hazard hazard : kHazards) EXPECT_TRUE(names.insert(name(hazard)).second);
}

TEST(HazardTerrain, refusesARoughnessBelowZero)
{
    std::mt19937_64 rng(1);
    EXPECT_THROW(randomHazardTerrain(Hazard::Drop, -1.0, rng), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
