#include "core/infer/estimate/edge_pressure.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/touch.h"
#include "core/sim/ground/terrain_path.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

constexpr double kRobotAt = 2.0;  // [m]
constexpr std::array<bool, kForceElements> kAllLoaded{true, true, true, true, true, true};

const RobotModel& robotOnEdge()
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    return robot;
}

/// Soft ground: the robot sinks in by about 15 mm.
constexpr GroundOptions kSoft{.softLayer = 0.025, .softStiffness = 110.0};

/// Readings without noise, front flippers pressed by 20 N m, rear flippers up.
Proprioception readingsOver(const TerrainProfile& terrain, const GroundOptions& ground = {})
{
    const auto rest =
        restPose(robotOnEdge(), terrain, kRobotAt, PressTorque{20.0}, HoldAngle{0.5}, 0.0, ground);
    return exactReadings(robotOnEdge(), *rest);
}

/// Level ground with a hole of 1 m depth between x = begin and end in front of the robot's middle.
TerrainProfile holeAhead(double begin, double end)
{
    TerrainPath path;
    path.level(kRobotAt + begin);
    path.face(-1.0);
    path.level(end - begin);
    path.face(1.0);
    return std::move(path).finish(6.0);
}

EdgePressure pressureOver(const TerrainProfile& terrain, const GroundOptions& ground = {})
{
    return {robotOnEdge(), readingsOver(terrain, ground).force, kAllLoaded};
}

TEST(EdgePressure, isLinearOverEvenGround)
{
    const Proprioception s = readingsOver(flatTerrain(6.0));
    const EdgePressure pressure(robotOnEdge(), s.force, kAllLoaded);
    EXPECT_TRUE(pressure.isEven());
    for (std::size_t e = 0; e < kForceElements; ++e) EXPECT_TRUE(pressure.hasItsShare(e)) << e;
    double sum = 0.0;
    for (const auto& force : s.force) sum += *force;
    EXPECT_NEAR(pressure.at(0.5), sum, 0.03 * sum);
}

TEST(EdgePressure, noiseSeldomMakesEvenGroundUneven)
{
    const Proprioception exact = readingsOver(flatTerrain(6.0));
    std::mt19937_64 rng(5);
    int uneven = 0, short1 = 0;
    constexpr int kTrials = 1000;
    for (int k = 0; k < kTrials; ++k) {
        const Proprioception s = noisy(exact, SensorNoise{}, robotOnEdge().forceSaturation, rng);
        const EdgePressure pressure(robotOnEdge(), s.force, kAllLoaded);
        uneven += pressure.isEven() ? 0 : 1;
        short1 += pressure.hasItsShare(0) ? 0 : 1;
    }
    EXPECT_LT(uneven, 50);
    EXPECT_GT(uneven, 2);
    EXPECT_NEAR(short1, 198, 60);  // 0.85 sd of one side
}

TEST(EdgePressure, holeUnderTheFlipperIsUneven)
{
    EXPECT_FALSE(pressureOver(holeAhead(0.38, 0.43)).isEven());
}

TEST(EdgePressure, holeUnderThePivotTakesFromElementOne)
{
    const EdgePressure pressure = pressureOver(holeAhead(0.10, 0.29));
    EXPECT_FALSE(pressure.hasItsShare(0));
    EXPECT_TRUE(pressure.hasItsShare(4));
}

TEST(EdgePressure, tipThatSinksInLeavesGroundEven)
{
    const EdgePressure pressure = pressureOver(flatTerrain(6.0), kSoft);
    EXPECT_TRUE(pressure.isEven());
    for (std::size_t e = 0; e < kForceElements; ++e) EXPECT_TRUE(pressure.hasItsShare(e)) << e;
    const auto force = readingsOver(flatTerrain(6.0), kSoft).force;
    EXPECT_GT(*force[5], 0.6 * *force[4]) << "the tip's circle adds to half a share";
}

TEST(EdgePressure, holeUnderTheFlipperIsUnevenOnSoftGround)
{
    EXPECT_FALSE(pressureOver(holeAhead(0.38, 0.46), kSoft).isEven());
}

TEST(EdgePressure, lightTipIsShort)
{
    const auto tipOf = [](double force) {
        const EdgePressure::Loads loads{10.0, 7.5, 7.5, 7.5, 7.5, force};
        return EdgePressure(robotOnEdge(), loads, kAllLoaded).hasItsShare(5);
    };
    EXPECT_TRUE(tipOf(3.7));  // half a share
    EXPECT_TRUE(tipOf(9.0));
    EXPECT_FALSE(tipOf(2.0));
}

TEST(EdgePressure, needsThreeLoadedElements)
{
    EXPECT_FALSE(EdgePressure(robotOnEdge(), {}, kAllLoaded).isEven());
    const EdgePressure::Loads two{15.0, 10.0, {}, {}, {}, {}};
    const EdgePressure pressure(robotOnEdge(), two, kAllLoaded);
    EXPECT_FALSE(pressure.isEven());
    EXPECT_FALSE(pressure.hasItsShare(0));
    EXPECT_TRUE(pressure.hasItsShare(3));  // not measured: nothing to compare
}

TEST(EdgePressure, saturatedElementIsNotShort)
{
    const EdgePressure::Loads force{20.0, 14.0, 12.5, 11.0, 9.5, 4.2};
    EXPECT_TRUE(EdgePressure(robotOnEdge(), force, kAllLoaded).hasItsShare(0));
    const EdgePressure::Loads steep{20.0, 20.0, 19.0, 8.5, 0.0, 0.0};
    const std::array<bool, kForceElements> rear{true, true, true, true, false, false};
    EXPECT_FALSE(EdgePressure(robotOnEdge(), steep, rear).hasItsShare(0)) << "63 N are expected";
}

TEST(EdgePressure, usesTheNoiseOfTheSimulator)
{
    EXPECT_DOUBLE_EQ(kForceSdShare, SensorNoise{}.forceShare);
    EXPECT_DOUBLE_EQ(kForceSdFloor, SensorNoise{}.forceFloor);
}

/// Returns the touch of +0.3 m with a hole that ends under the front of the tracks.
Touch firstBinAheadOf(const TerrainProfile& terrain)
{
    const Proprioception s = readingsOver(terrain);
    return pressedBins(robotOnEdge(), s, bodyCeiling(robotOnEdge(), s.pitch, s.front, s.rear))
        .touch[6];
}

TEST(EdgePressure, holeThatEndsUnderTheTracksIsNotFelt)
{
    EXPECT_EQ(firstBinAheadOf(flatTerrain(6.0)), Touch::Felt);
    EXPECT_EQ(firstBinAheadOf(holeAhead(0.10, 0.29)), Touch::FeltInPart);
    EXPECT_NE(firstBinAheadOf(holeAhead(0.28, 0.33)), Touch::Felt);
}

TEST(EdgePressure, steepSlopeHidesGroundUnderThePivot)
{
    EXPECT_EQ(firstBinAheadOf(slopeTerrain(0.03, 0.5, 6.0)), Touch::Felt);
    EXPECT_NE(firstBinAheadOf(slopeTerrain(0.06, 0.5, 6.0)), Touch::Felt);
}

}  // namespace
}  // namespace terratact
