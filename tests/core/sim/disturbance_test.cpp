#include "core/sim/disturbance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/terrain/body_ceiling.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Returns the scenes of one drive over a box under a disturbance, with no other noise.
std::vector<Scene> driveUnder(Disturbance disturbance, const TerrainProfile& terrain)
{
    const RobotModel robot = disturbed(absolem(), disturbance);
    std::mt19937_64 rng(1);
    int skipped = 0;
    auto scenes = driveOver(robot, terrain, stopsOver(terrain, 0.2), "1", {},
                            disturbedDrive(SensorNoise::none(), robot.forceSaturation, disturbance),
                            rng, skipped);
    EXPECT_EQ(skipped, 0) << name(disturbance);
    return scenes;
}

double baseHeight(Disturbance disturbance, const FlipperDrive& front)
{
    const auto rest = restPose(disturbed(absolem(), disturbance), flatTerrain(6.0), 3.0, front,
                               HoldAngle{0.4}, 0.0, disturbed(GroundOptions{}, disturbance));
    EXPECT_TRUE(rest);
    EXPECT_NEAR(rest->pose.pitch, 0.0, 0.1);
    return rest->pose.base.z;
}

TEST(Disturbances, areFoundByTheirNames)
{
    for (const Disturbance d : kDisturbances) EXPECT_EQ(disturbanceFromName(name(d)), d);
    EXPECT_FALSE(disturbanceFromName("earthquake"));
}

TEST(Disturbances, changeOnlyTheirOwnQuantity)
{
    EXPECT_DOUBLE_EQ(disturbed(SensorNoise{}, Disturbance::ImuNoise).pitch, 0.0175);
    EXPECT_DOUBLE_EQ(disturbed(SensorNoise{}, Disturbance::SoftGround).pitch, SensorNoise{}.pitch);
    const RobotModel robot = absolem();
    EXPECT_DOUBLE_EQ(disturbed(robot, Disturbance::LightRobot).totalMass(),
                     0.8 * robot.totalMass());
    EXPECT_DOUBLE_EQ(disturbed(robot, Disturbance::HeavyRobot).totalMass(),
                     1.2 * robot.totalMass());
    EXPECT_DOUBLE_EQ(disturbed(robot, Disturbance::ForcesLow).totalMass(), robot.totalMass());
    EXPECT_DOUBLE_EQ(disturbedDrive({}, 20.0, Disturbance::FrictionFree).slide, 0.05);
    EXPECT_DOUBLE_EQ(disturbedDrive({}, 20.0, Disturbance::HeavyRobot).slide, 0.0);
}

TEST(Disturbances, ofReadingsKeepWithinTheSensorsRange)
{
    Proprioception s;
    s.force = {0.0, 4.0, std::nullopt, 8.0, 18.0, 20.0};
    const Proprioception high = disturbed(s, 20.0, Disturbance::ForcesHigh);
    EXPECT_EQ(high.force, (decltype(s.force){0.0, 5.0, std::nullopt, 10.0, 20.0, 20.0}));
    const Proprioception low = disturbed(s, 20.0, Disturbance::ForcesLow);
    EXPECT_EQ(low.force, (decltype(s.force){0.0, 3.0, std::nullopt, 6.0, 13.5, 15.0}));
    const Proprioception dead = disturbed(s, 20.0, Disturbance::DeadElement);
    EXPECT_EQ(dead.force, (decltype(s.force){0.0, 4.0, std::nullopt, 0.0, 18.0, 20.0}));
    EXPECT_EQ(disturbed(s, 20.0, Disturbance::None), s);
}

TEST(SoftGround, letsALevelRobotSinkByTwoCentimetres)
{
    const FlipperDrive raised = HoldAngle{0.7};
    const double sunk =
        baseHeight(Disturbance::None, raised) - baseHeight(Disturbance::SoftGround, raised);
    EXPECT_GT(sunk, 0.015);
    EXPECT_LT(sunk, 0.025);
    // Pressed flippers carry part of the load and lift the front.
    const FlipperDrive pressed = PressTorque{18.0};
    const double alsoSunk =
        baseHeight(Disturbance::None, pressed) - baseHeight(Disturbance::SoftGround, pressed);
    EXPECT_GT(alsoSunk, 0.005);
    EXPECT_LT(alsoSunk, sunk);
}

TEST(SoftGround, carriesTheWholeRobot)
{
    const RobotModel robot = absolem();
    const auto rest =
        restPose(robot, boxTerrain(0.2, 2.8, 1.0, 6.0), 2.5, PressTorque{18.0}, HoldAngle{0.2}, 0.0,
                 disturbed(GroundOptions{}, Disturbance::SoftGround));
    ASSERT_TRUE(rest);
    double up = 0.0;
    for (const GroundContact& c : rest->contacts) up += c.force.z;
    EXPECT_NEAR(up, 9.81 * robot.totalMass(), 0.5);
}

TEST(SoftGround, liftsTheTruthAboveTheRigidCeiling)
{
    const auto scenes = driveUnder(Disturbance::SoftGround, flatTerrain(4.0));
    ASSERT_FALSE(scenes.empty());
    const Scene& scene = scenes.front();
    const RobotModel robot = absolem();
    const Heights ceiling = bodyCeiling(robot, scene.s.pitch, scene.s.front, scene.s.rear);
    EXPECT_GT(*scene.truth[3], ceiling[3] + 0.005);
}

TEST(SoftGround, hidesNothingMuchDeeperThanItsLayer)
{
    const RobotModel robot = absolem();
    const GroundOptions soft = disturbed(GroundOptions{}, Disturbance::SoftGround);
    for (double x = 2.0; x < 4.2; x += 0.1) {
        const auto rest = restPose(robot, boxTerrain(0.2, 2.8, 1.0, 6.0), x, PressTorque{18.0},
                                   HoldAngle{0.2}, 0.0, soft);
        ASSERT_TRUE(rest) << x;
        for (const GroundContact& c : rest->contacts)
            EXPECT_LT(c.depth, soft.softLayer + 1e-3) << x;
    }
}

TEST(FrictionFree, slidesDownASlope)
{
    const TerrainProfile slope = slopeTerrain(0.2, 0.5, 6.0);
    const auto held = driveUnder(Disturbance::None, slope);
    const auto slid = driveUnder(Disturbance::FrictionFree, slope);
    ASSERT_EQ(held.size(), slid.size());
    // 5 cm further down a uniform slope nothing changes. Between level ground and the slope, the
    // nose is lower.
    EXPECT_NEAR(held[held.size() / 2].s.pitch, slid[held.size() / 2].s.pitch, 1e-3);
    bool lower = false;
    for (std::size_t k = 0; k < held.size(); ++k) {
        EXPECT_LT(slid[k].s.pitch, held[k].s.pitch + 1e-3) << k;
        lower = lower || slid[k].s.pitch < held[k].s.pitch - 0.02;
    }
    EXPECT_TRUE(lower);
}

TEST(Disturbances, leaveScenesOverVariedGround)
{
    std::mt19937_64 rng(7);
    const TerrainProfile terrain = randomVariedTerrain(rng);
    const auto plain = driveUnder(Disturbance::None, terrain);
    for (const Disturbance d : kDisturbances) {
        if (d == Disturbance::None) continue;
        const auto scenes = driveUnder(d, terrain);
        EXPECT_EQ(scenes.size(), plain.size()) << name(d);
        EXPECT_NE(scenes, plain) << name(d);
    }
}

}  // namespace
}  // namespace terratact
