#include "core/sim/rest/two_track_rest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <stdexcept>

#include "core/sim/drive.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/rest/rest_search.h"
#include "tests/core/sim/rest/some_ground.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kX = 3.0;

GroundLines twoSides(const TerrainProfile& left, const TerrainProfile& right)
{
    return GroundLines({{0.2, left}, {-0.2, right}});
}

TerrainProfile level(double height)
{
    return TerrainProfile({{0.0, height}, {6.0, height}});
}

double largestDifference(const TwoTrackReadings& a, const TwoTrackReadings& b)
{
    double largest = std::max(std::abs(a.pitch - b.pitch), std::abs(a.roll - b.roll));
    for (std::size_t i = 0; i < kFlippers; ++i)
        largest = std::max(largest, std::abs(a.flippers[i] - b.flippers[i]));
    return largest;
}

double largestForceDifference(const TwoTrackReadings& a, const TwoTrackReadings& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < kFlippers; ++i)
        for (std::size_t e = 0; e < kForceElements; ++e)
            largest = std::max(
                largest, std::abs(a.forces[i][e].value_or(0.0) - b.forces[i][e].value_or(0.0)));
    return largest;
}

/// Returns the plane's readings as those of both sides.
TwoTrackReadings onBothSides(const Proprioception& s)
{
    TwoTrackReadings readings;
    readings.pitch = s.pitch;
    readings.flippers = {s.front, s.front, s.rear, s.rear};
    readings.currents = {s.frontCurrent, s.frontCurrent, s.rearCurrent, s.rearCurrent};
    readings.forces[0] = readings.forces[1] = s.force;
    return readings;
}

TEST(TwoTrackRest, onEqualLinesIsThePlanesPose)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(1);
    int poses = 0, equal = 0;
    // By default both searches end up to 1e-6 rad before the minimum; here they go on to it.
    const auto settled = [](GroundOptions ground) {
        ground.settled = 1e-20;
        return ground;
    };
    while (poses < 1000) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        const DriveStyle style = randomDriveStyle(rng);
        const GroundOptions ground =
            settled(poses % 3 == 0 ? randomSoftGround(rng) : GroundOptions{});
        const FlipperDrive front = PressTorque{style.pressTorque},
                           rear = HoldAngle{style.rearAngle};
        double pitch = 0.0;
        for (const double x : stopsOver(terrain, 0.41)) {
            const auto plane = restPose(robot, terrain, x, front, rear, pitch, ground);
            const auto rest = restPose(robot, GroundLines(terrain), x, flipperDrives(front, rear),
                                       {pitch, 0.0}, ground);
            ++poses;
            if (!plane && !rest) ++equal;
            if (!plane || !rest) continue;
            pitch = plane->pose.pitch;
            const TwoTrackReadings expected = onBothSides(exactReadings(robot, *plane));
            const TwoTrackReadings readings = exactReadings(robot, *rest);
            equal += largestDifference(expected, readings) <= 1e-9
                  && largestForceDifference(expected, readings) <= 0.01
                  && std::abs(plane->pose.base.z - rest->pose.base.z) <= 1e-9;
        }
    }
    std::printf("equal lines: the pose of one plane in %d of %d poses\n", equal, poses);
    EXPECT_GE(equal, 0.99 * poses);
}

TEST(TwoTrackRest, onMirroredGroundHasMirroredReadings)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(2);
    int compared = 0, poses = 0;
    double largest = 0.0;
    for (int run = 0; run < 60; ++run) {
        const GroundLines ground = someGround(rng);
        const double x = placeOn(ground, rng);
        const double roll = std::uniform_real_distribution<double>(-0.1, 0.1)(rng);
        const auto rest = restPose(robot, ground, x, kDrives, {0.0, roll});
        const auto mirror = restPose(robot, ground.mirrored(), x, kDrives, {0.0, -roll});
        ASSERT_EQ(bool(rest), bool(mirror)) << "run " << run;
        if (!rest) continue;
        const auto readings = exactReadings(robot, *rest);
        const auto back = mirrored(exactReadings(robot, *mirror));
        largest = std::max(largest, largestDifference(readings, back));
        ++poses;
        EXPECT_LT(largestDifference(readings, back), 1e-6) << "run " << run;
        EXPECT_LT(largestForceDifference(readings, back), 0.01) << "run " << run;
        compared += std::abs(rest->pose.roll) > 0.02;
    }
    std::printf("mirrored ground: %d poses, largest difference %.1e rad\n", poses, largest);
    EXPECT_GT(compared, 20);
}

TEST(TwoTrackRest, carriesTheWeightOnBothSides)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(5);
    for (int run = 0; run < 30; ++run) {
        const GroundLines ground = someGround(rng);
        const auto rest = restPose(robot, ground, placeOn(ground, rng), kDrives);
        if (!rest) continue;
        std::array<double, 2> force{};
        for (std::size_t side = 0; side < 2; ++side)
            for (const GroundContact& c : rest->contacts[side]) {
                force[side] += c.force.z;
                EXPECT_LT(c.depth, GroundOptions{}.skin) << "run " << run;
            }
        EXPECT_NEAR(force[0] + force[1], robot.totalMass() * kGravity, 0.5) << "run " << run;
        EXPECT_GT(force[0], 1.0);
        EXPECT_GT(force[1], 1.0);
    }
}

TEST(TwoTrackRest, onACrossSlopeRollsByIt)
{
    const RobotModel robot = absolem();
    for (const double angle : {-0.3, 0.1, 0.25}) {
        std::vector<GroundLine> lines;
        for (const double y : {0.272, 0.1985, -0.1985, -0.272})
            lines.push_back({y, level(y * std::tan(angle))});
        const auto rest = restPose(robot, GroundLines(lines), kX, kDrives);
        ASSERT_TRUE(rest);
        EXPECT_NEAR(std::sin(rest->pose.roll), std::tan(angle), 2e-3);  // lines keep their y
        EXPECT_NEAR(rest->pose.pitch, 0.0, 2e-3);
    }
}

TEST(TwoTrackRest, withItsMassToOneSideLoadsThatSideMore)
{
    RobotModel robot = absolem();
    robot.lateral.bodyComY = 0.1;
    const auto rest = restPose(robot, GroundLines(flatTerrain(6.0)), kX, kDrives);
    ASSERT_TRUE(rest);
    double left = 0.0, right = 0.0;
    for (const GroundContact& c : rest->contacts[0]) left += c.force.z;
    for (const GroundContact& c : rest->contacts[1]) right += c.force.z;
    EXPECT_GT(left, 2.0 * right);
}

TEST(TwoTrackRest, tipsOverSidewaysOnASteepCrossSlope)
{
    const auto rest = restPose(absolem(), twoSides(level(0.4), level(0.0)), kX, kDrives);
    ASSERT_FALSE(rest);
    EXPECT_NE(rest.error().text.find("tips over sideways"), std::string::npos) << rest.error().text;
}

TEST(TwoTrackRest, namesAFlipperThatHangsOverADrop)
{
    const RobotModel robot = absolem();
    const TerrainProfile drop = stepTerrain(-1.0, 3.1, 6.0);
    const auto rest = restPose(
        robot, GroundLines({{0.272, drop}, {0.1985, flatTerrain(6.0)}, {-0.2, flatTerrain(6.0)}}),
        kX, kDrives);
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->hangs, (PerFlipper<bool>{true, false, false, false}));
    EXPECT_DOUBLE_EQ(rest->pose.flippers[0], kLowestFlipper);
    EXPECT_NEAR(rest->pose.flippers[1], 0.0, 0.05);
    EXPECT_NEAR(rest->torques[1], 9.0, 1e-3);
    const TwoTrackReadings readings = exactReadings(robot, *rest);
    for (const auto& force : readings.forces[0]) EXPECT_EQ(force, 0.0);
}

TEST(TwoTrackRest, namesAFlipperThatGivesWay)
{
    RobotModel robot = absolem();
    robot.lateral.bodyComY = 0.1;  // the left rear flipper carries more
    robot.maxFlipperTorque = 18.5;
    const auto drives = flipperDrives(HoldAngle{0.7}, HoldAngle{-0.6});
    const auto rest = restPose(robot, GroundLines(flatTerrain(6.0)), kX, drives);
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->gaveWay, (PerFlipper<bool>{false, false, true, false}));
    EXPECT_NEAR(rest->torques[2], robot.maxFlipperTorque, 1e-3);
    EXPECT_GT(rest->pose.flippers[2], -0.6);
    EXPECT_EQ(rest->pose.flippers[3], -0.6);
}

TEST(TwoTrackRest, keepsItsRollWhenItStartsFromIt)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(11);
    int poses = 0, kept = 0;
    while (poses < 200) {
        const GroundLines ground = someGround(rng);
        const double x = placeOn(ground, rng);
        const auto rest = restPose(robot, ground, x, kDrives);
        if (!rest) continue;
        ++poses;
        const auto again = restPose(robot, ground, x, kDrives, {rest->pose.pitch, rest->pose.roll});
        kept += again && std::abs(again->pose.roll - rest->pose.roll) < 0.002;
    }
    EXPECT_GE(kept, 0.9 * poses) << kept << " of " << poses;
}

/// Returns the rest pose at the same x with another roll. A start with 0.12 rad more or less roll leads to it.
std::optional<TwoTrackRest> withAnotherRoll(const RobotModel& robot, const GroundLines& ground,
                                            const TwoTrackRest& rest)
{
    for (const double tilt : {0.12, -0.12}) {
        auto other = restPose(robot, ground, rest.pose.base.x, kDrives,
                              {rest.pose.pitch, rest.pose.roll + tilt});
        if (other && std::abs(other->pose.roll - rest.pose.roll) > 0.01) return *std::move(other);
    }
    return std::nullopt;
}

TEST(TwoTrackRest, startsChooseAmongStableRolls)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(12);
    int found = 0, poses = 0;
    for (; poses < 200; ++poses) {
        const GroundLines ground = someGround(rng);
        const double x = placeOn(ground, rng);
        const auto rest = restPose(robot, ground, x, kDrives);
        if (!rest) continue;
        const auto other = withAnotherRoll(robot, ground, *rest);
        if (!other) continue;
        ++found;
        const TwoTrackPotential potential(robot, ground, x, other->drives, {});
        for (const double tilt : {-1e-3, 1e-3}) {
            TwoTrackPose pose = other->pose;
            pose.roll += tilt;
            EXPECT_GT(potential(pose, GroundOptions{}.stiffness, nullptr, nullptr), other->energy);
        }
    }
    EXPECT_GT(found, 2);
    EXPECT_LT(found, poses / 5);
    const GroundLines flat(flatTerrain(6.0));
    const auto onFlat = restPose(robot, flat, kX, kDrives);
    ASSERT_TRUE(onFlat);
    EXPECT_FALSE(withAnotherRoll(robot, flat, *onFlat));
}

TEST(TwoTrackRest, withAFreeDifferentialKeepsBothTracksOnTheGround)
{
    RobotModel robot = absolem();
    const GroundLines ground = twoSides(TerrainProfile({{0.0, -0.6}, {6.0, 0.6}}),
                                        TerrainProfile({{0.0, 0.6}, {6.0, -0.6}}));
    const PerFlipper<FlipperDrive> raised = flipperDrives(HoldAngle{0.9}, HoldAngle{0.9});
    const auto locked = restPose(robot, ground, kX, raised);
    robot.differential.locked = false;
    const auto free = restPose(robot, ground, kX, raised);
    ASSERT_TRUE(locked && free);
    EXPECT_NEAR(free->pose.differential, 0.2, 0.01);
    EXPECT_EQ(locked->pose.differential, 0.0);
    EXPECT_LT(free->energy, locked->energy);
    EXPECT_EQ(exactReadings(robot, *free).differential, free->pose.differential);
    robot.differential.limit = 0.1;
    const auto limited = restPose(robot, ground, kX, raised);
    ASSERT_TRUE(limited);
    EXPECT_TRUE(limited->differentialAtLimit);
    EXPECT_DOUBLE_EQ(limited->pose.differential, 0.1);
}

TEST(TwoTrackRest, neverTurnsTheDifferentialBeyondItsLimit)
{
    RobotModel robot = absolem();
    robot.differential.locked = false;
    robot.differential.limit = 0.03;
    robot.maxFlipperTorque = 12.0;  // so that flippers give way often
    std::mt19937_64 rng(8);
    int atLimit = 0, gaveWay = 0;
    for (int go = 0; go < 300; ++go) {
        const GroundLines ground = someGround(rng);
        const auto rest = restPose(robot, ground, placeOn(ground, rng), kDrives);
        if (!rest) continue;
        const double differential = std::abs(rest->pose.differential);
        EXPECT_LE(differential, robot.differential.limit) << go;
        EXPECT_EQ(rest->differentialAtLimit, differential == robot.differential.limit) << go;
        for (std::size_t i = 0; i < kFlippers; ++i)
            EXPECT_TRUE(!isPressed(rest->drives[i]) || rest->gaveWay[i]
                        || rest->pose.flippers[i] >= kLowestFlipper)
                << go;
        atLimit += rest->differentialAtLimit;
        gaveWay += std::ranges::count(rest->gaveWay, true) > 0;
    }
    EXPECT_GT(atLimit, 50);
    EXPECT_GT(gaveWay, 20);
}

TEST(TwoTrackRest, readsTheForcesOfTheArraysThatExist)
{
    RobotModel robot = absolem();
    robot.rearElementShare = robot.elementShare;
    robot.forceArrays = {{"R", Side::Right, {true, true, true, true, true, true}}};
    const auto drives = flipperDrives(PressTorque{18.0}, PressTorque{18.0});
    // Steps up under the front flippers and behind the robot, under the rear ones.
    const TerrainProfile pit(
        {{0.0, 0.2}, {2.5, 0.2}, {2.5, 0.0}, {3.5, 0.0}, {3.5, 0.2}, {6.0, 0.2}});
    const auto rest = restPose(robot, GroundLines(pit), kX, drives);
    ASSERT_TRUE(rest);
    const TwoTrackReadings readings = exactReadings(robot, *rest);
    EXPECT_FALSE(readings.forces[0][5]);
    for (const std::size_t flipper : {1U, 2U, 3U}) {
        double felt = 0.0;
        for (const auto& force : readings.forces[flipper]) {
            ASSERT_TRUE(force);
            felt += *force;
        }
        EXPECT_GT(felt, 5.0) << flipper;
    }
    EXPECT_NEAR(*readings.forces[2][4], *readings.forces[3][4], 1e-6);
}

TEST(TwoTrackRest, refusesNumbersThatAreNotFinite)
{
    const RobotModel robot = absolem();
    const GroundLines flat(flatTerrain(6.0));
    const double nan = std::nan("");
    EXPECT_THROW((void)restPose(robot, flat, nan, kDrives), std::invalid_argument);
    EXPECT_THROW((void)restPose(robot, flat, kX, kDrives, {0.0, nan}), std::invalid_argument);
    auto drives = kDrives;
    drives[3] = HoldAngle{nan};
    EXPECT_THROW((void)restPose(robot, flat, kX, drives), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
