#include "core/sim/rest/rest_pose.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "core/sim/drive.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/two_track_rest.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kGravity = 9.81;
constexpr FlipperDrive kPress = PressTorque{18.0};
constexpr FlipperDrive kRear = HoldAngle{0.2};

double upward(const RestPose& rest)
{
    double force = 0.0;
    for (const GroundContact& c : rest.contacts) force += c.force.z;
    return force;
}

/// Returns the moment of all ground forces about the base's origin [N m].
double groundMoment(const RestPose& rest)
{
    double moment = 0.0;
    for (const GroundContact& c : rest.contacts)
        moment +=
            (c.point.x - rest.pose.base.x) * c.force.z - (c.point.z - rest.pose.base.z) * c.force.x;
    return moment;
}

/// Returns the moment of the weight about the base's origin [N m].
double weightMoment(const RobotModel& robot, const Pose& pose)
{
    const auto flipper = [&](const FlipperGeometry& f, double angle) {
        const Vec2 axis = flipperAxis(f, angle);
        const Vec2 com =
            toWorld(pose, {f.pivot.x + f.comDistance * axis.x, f.pivot.z + f.comDistance * axis.z});
        return -f.mass * kGravity * (com.x - pose.base.x);
    };
    return -robot.bodyMass * kGravity * (toWorld(pose, robot.bodyCom).x - pose.base.x)
         + flipper(robot.front, pose.front) + flipper(robot.rear, pose.rear);
}

/// Returns true for contacts on the front flippers beyond the pivot's circle, which rests on the
/// ground beside the tracks.
bool onSensor(const RobotModel& robot, const RestPose& rest, const GroundContact& c)
{
    return c.part == GroundContact::Part::Front
        && c.point.x > toWorld(rest.pose, robot.front.pivot).x + robot.front.pivotRadius;
}

TEST(RestPose, onFlatGroundStandsLevelAtTheBasesHeight)
{
    const RobotModel robot = absolem();
    const auto rest = restPose(robot, flatTerrain(6.0), 3.0, kPress, kRear);
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->pose.base.z, robot.baseHeight, 3e-4);  // analytic; the skin is 0.2 mm
    EXPECT_NEAR(rest->pose.pitch, 0.0, 2e-4);
    EXPECT_NEAR(rest->pose.front, 0.0, 2e-3);
    EXPECT_DOUBLE_EQ(rest->pose.rear, 0.2);
}

TEST(RestPose, onASlopeLiesAlongIt)
{
    for (const double angle : {-0.25, 0.1, 0.3}) {
        const auto rest = restPose(absolem(), slopeTerrain(angle, 0.5, 6.0), 3.0, kPress, kRear);
        ASSERT_TRUE(rest);
        EXPECT_NEAR(rest->pose.pitch, angle, 1e-3);
    }
}

TEST(RestPose, balancesForcesAndMoments)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(5);
    for (int run = 0; run < 12; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        for (const double x : stopsOver(terrain, 0.41)) {
            const auto rest = restPose(robot, terrain, x, kPress, kRear);
            if (!rest) continue;
            EXPECT_NEAR(upward(*rest), robot.totalMass() * kGravity, 0.5)
                << "run " << run << " x " << x;
            EXPECT_NEAR(groundMoment(*rest) + weightMoment(robot, rest->pose), 0.0, 0.5)
                << "run " << run << " x " << x;
        }
    }
}

TEST(RestPose, pressesTheFlippersWithTheCommandedTorque)
{
    const auto rest =
        restPose(absolem(), stepTerrain(0.2, 3.0, 6.0), 2.5, PressTorque{14.0}, kRear);
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->frontTorque, 14.0, 1e-3);
}

TEST(RestPose, touchesAStepAtItsEdge)
{
    const auto rest = restPose(absolem(), stepTerrain(0.2, 3.0, 6.0), 2.5, kPress, kRear);
    ASSERT_TRUE(rest);
    bool edge = false;
    for (const GroundContact& c : rest->contacts) {
        if (!onSensor(absolem(), *rest, c)) continue;
        edge = edge || std::hypot(c.point.x - 3.0, c.point.z - 0.2) < 1e-6;
        EXPECT_LT(std::hypot(c.point.x - 3.0, c.point.z - 0.2), 0.011);
    }
    EXPECT_TRUE(edge);
}

TEST(RestPose, isALocalMinimumOfTheEnergy)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(17);
    std::normal_distribution<double> normal;
    for (int run = 0; run < 6; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        const auto stops = stopsOver(terrain, 0.01);
        const double x = stops[static_cast<std::size_t>(rng() % stops.size())];
        const auto rest = restPose(robot, terrain, x, kPress, kRear);
        ASSERT_TRUE(rest);
        const TwoTrackPotential potential(robot, GroundLines(terrain), x,
                                          flipperDrives(rest->front, rest->rear), {});
        for (int k = 0; k < 1000; ++k) {
            const double size = std::pow(10.0, -1.0 - 4.0 * (k % 5) / 4.0);
            Pose pose = rest->pose;
            pose.base.z += 0.01 * size * normal(rng);
            pose.pitch += 0.03 * size * normal(rng);
            if (std::holds_alternative<PressTorque>(rest->front))
                pose.front += 0.1 * size * normal(rng);
            const TwoTrackPose onBothTracks{
                .base = pose.base,
                .pitch = pose.pitch,
                .flippers = {pose.front, pose.front, pose.rear, pose.rear}};
            EXPECT_GE(potential(onBothTracks, GroundOptions{}.stiffness, nullptr, nullptr),
                      rest->energy - 1e-8)
                << "run " << run << " x " << x << " perturbation " << k;
        }
    }
}

TEST(RestPose, hasNoTerrainAboveTheRobot)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(23);
    for (int run = 0; run < 12; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        for (const double x : stopsOver(terrain, 0.53)) {
            const auto rest = restPose(robot, terrain, x, kPress, kRear);
            if (!rest) continue;
            for (const GroundContact& c :
                 rest->contacts)  // springs stay inside the skin: the body itself touches nothing
                EXPECT_LT(c.depth, GroundOptions{}.skin) << "run " << run << " x " << x;
        }
    }
}

TEST(RestPose, onSymmetricTerrainIsSymmetric)
{
    RobotModel robot = absolem();
    robot.bodyCom.x = 0.0;
    const TerrainProfile bowl(
        {{0.0, 0.4}, {2.6, 0.1}, {2.9, 0.0}, {3.1, 0.0}, {3.4, 0.1}, {6.0, 0.4}});
    const auto rest = restPose(robot, bowl, 3.0, kPress, PressTorque{18.0});
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->pose.pitch, 0.0, 1e-4);
    EXPECT_NEAR(rest->pose.front, rest->pose.rear, 1e-3);
}

TEST(RestPose, holdsFlippersThatFindNoGround)
{
    const auto rest = restPose(absolem(), stepTerrain(-1.0, 3.0, 6.0), 2.85, kPress, kRear);
    ASSERT_TRUE(rest);
    EXPECT_DOUBLE_EQ(rest->pose.front, kLowestFlipper);
    EXPECT_LT(rest->frontTorque, 18.0);
}

TEST(RestPose, neverAsksMoreOfTheMotorsThanTheyHave)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(29);
    for (int run = 0; run < 20; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        for (const double x : stopsOver(terrain, 0.61)) {
            const auto rest = restPose(robot, terrain, x, kPress, kRear);
            if (!rest) continue;
            EXPECT_LE(std::abs(rest->rearTorque), 2.0 * robot.maxFlipperTorque + 0.5)
                << "run " << run << " x " << x;
        }
    }
}

TEST(RestPose, isFoundInAboutAMillisecond)
{
    // This is a hang guard. tests/bench prints the time itself (below 2 ms, release, one core).
    const RobotModel robot = absolem();
    std::mt19937_64 rng(31);
    const TerrainProfile terrain = randomVariedTerrain(rng);
    const auto start = std::chrono::steady_clock::now();
    for (const double x : stopsOver(terrain, 0.05))
        (void)restPose(robot, terrain, x, kPress, kRear);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(RestPose, readsOnlyTheTerrainUnderTheRobot)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(5);
    constexpr double kX = 2500.0;
    std::vector<Vec2> points, piece;
    double x = 0.0;
    while (points.size() < 100'000) {
        const bool near = std::abs(x - kX) < 0.8;  // fine steps in the part that must not be read
        points.push_back({x, 0.02 * std::uniform_real_distribution<double>(-1.0, 1.0)(rng)});
        if (near) piece.push_back(points.back());
        x += near || std::abs(x - kX) > 20.0 ? 0.05 : 0.001;
    }
    ASSERT_GT(x, kX + 20.0);
    const auto onAll = restPose(robot, TerrainProfile(points), kX, kPress, kRear);
    const auto onPiece = restPose(robot, TerrainProfile(piece), kX, kPress, kRear);
    ASSERT_TRUE(onAll && onPiece);
    EXPECT_EQ(onAll->terrainPoints, onPiece->terrainPoints);
    EXPECT_EQ(onAll->pose.base.z, onPiece->pose.base.z);
    EXPECT_EQ(onAll->energy, onPiece->energy);
    EXPECT_GT(onAll->terrainPoints, 300U);  // 1.5 m in steps of 5 mm
}

/// Its level flippers reach further than those of the robot in the other tests.
TEST(RestPose, holdsTheWholeOfALargerRobot)
{
    for (const double axleDistance : {0.319, 0.7, 1.0}) {
        RobotModel robot = absolem();
        for (FlipperGeometry* f : {&robot.front, &robot.rear}) f->axleDistance = axleDistance;
        // The wall is within reach of the front flipper's tip only.
        const double tip = robot.front.pivot.x + axleDistance;
        const TerrainProfile wall(
            {{0.0, 0.0}, {3.0 + tip - 0.03, 0.0}, {3.0 + tip - 0.03, 0.3}, {8.0, 0.3}});
        const auto rest = restPose(robot, wall, 3.0, HoldAngle{0.4}, HoldAngle{0.4});
        ASSERT_TRUE(rest) << axleDistance;
        const RobotShape shape = shapeAt(robot, rest->pose);
        for (const Vec2 p : wall.sampled(1.0, 7.0, 0.001))
            EXPECT_GT(lowerEnvelope(shape, p.x), p.z - 1e-3) << axleDistance << " at " << p.x;
    }
}

TEST(ElementForces, concentrateWhereTheEdgeTouches)
{
    const RobotModel robot = absolem();
    const auto rest = restPose(robot, stepTerrain(0.2, 3.0, 6.0), 2.5, kPress, kRear);
    ASSERT_TRUE(rest);
    const auto force = elementForces(robot, *rest);
    double onFlipper = 0.0;
    double felt = 0.0;
    for (const GroundContact& c : rest->contacts)
        if (onSensor(robot, *rest, c)) onFlipper += 0.5 * std::hypot(c.force.x, c.force.z);
    for (const double f : force) felt += f;
    // one flipper's half of the load, fully distributed
    EXPECT_NEAR(felt, onFlipper, 0.01 * onFlipper);
    EXPECT_DOUBLE_EQ(force[0], 0.0);
    EXPECT_GT(force[3] + force[4] + force[5], 0.99 * felt);
}

}  // namespace
}  // namespace terratact
