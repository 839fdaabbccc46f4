#include "core/sim/simulated_robot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

SimulatedRobot robotBefore(double distance, double height = 0.24)
{
    SimulatedRobot::Options options;
    options.startX = 3.0 - distance;
    options.probeSeconds = 2.0;
    return SimulatedRobot(absolem(), stepTerrain(height, 3.0, 6.0), options);
}

template <class Condition>
bool within(SimulatedRobot& robot, double seconds, Condition condition)
{
    for (double t = 0.0; t < seconds; t += 0.05) {
        robot.step(0.05);
        if (condition(robot.measure())) return true;
    }
    return false;
}

bool isPressed(const Measurement& m)
{
    return m.activity == RobotActivity::Pressed;
}

TEST(SimulatedRobot, reportsNoWayThatItsTracksDidNotRoll)
{
    for (const double drop : {0.6, 0.9}) {
        SimulatedRobot::Options options;
        options.startX = 0.8;
        SimulatedRobot robot(
            absolem(), TerrainProfile({{0, 0}, {2.5, 0}, {2.51, -drop}, {4, -drop}}), options);
        double before = 0.0;
        int halts = 0;
        for (int line = 0; line < 400; ++line) {
            if (robot.activity() == RobotActivity::Halted)
                ++halts, robot.command(DriveCommand{0.2});
            for (int i = 0; i < 5; ++i) robot.step(0.01);
            const double travelled = *robot.measure().travelled;
            EXPECT_LT(std::abs(travelled - before), 0.3)
                << "at once, of a drop of " << drop << " m";
            before = travelled;
        }
        EXPECT_GT(halts, 2) << "it finds no pose to rest in, and is told to drive on";
    }
}

/// Returns ground with a kerb of this height at x = 3 m on the left. The right is level.
GroundLines kerbLeft(double height)
{
    return GroundLines({{0.2, stepTerrain(height, 3.0, 6.0)}, {-0.2, stepTerrain(0.0, 3.0, 6.0)}});
}

/// Returns a robot with exact sensors whose front flippers press on this ground, before the kerb.
SimulatedRobot pressedBefore(const GroundLines& ground, double distance)
{
    SimulatedRobot::Options options;
    options.startX = 3.0 - distance;
    options.noise = SensorNoise::none();
    SimulatedRobot robot(absolem(), ground, options);
    robot.command(PressCommand{16.0});
    EXPECT_TRUE(within(robot, 6.0, isPressed));
    return robot;
}

TEST(SimulatedRobot, feelsAKerbOnOneSideThere)
{
    SimulatedRobot robot = pressedBefore(kerbLeft(0.12), 0.45);
    const Measurement m = robot.measure();
    EXPECT_GT(m.frontLeft, m.frontRight + 0.1) << "the left flipper lies on the kerb";
    EXPECT_NE(m.sides.left, m.sides.right);
    for (std::size_t e = 0; e < kForceElements; ++e) {
        ASSERT_TRUE(m.sides.left[e] && m.sides.right[e]) << e;
        EXPECT_DOUBLE_EQ(m.force[e], (*m.sides.left[e] + *m.sides.right[e]) / 2.0) << e;
    }
    EXPECT_NEAR(robot.stance().frontTorque(Side::Left), 8.0, 0.01);
    EXPECT_NEAR(robot.stance().frontTorque(Side::Right), 8.0, 0.01);
    EXPECT_EQ(twoTrackReadings(m), exactReadings(absolem(), *robot.stance().tracks()));
}

TEST(SimulatedRobot, rollsOnAKerbOnOneSide)
{
    SimulatedRobot robot = pressedBefore(kerbLeft(0.08), 1.5);
    EXPECT_NEAR(robot.measure().roll, 0.0, 1e-6);
    robot.command(DriveCommand{0.3});
    ASSERT_TRUE(within(robot, 15.0, [&](const Measurement&) { return robot.pose().base.x > 3.3; }));
    const LateralGeometry lateral = absolem().lateral;
    EXPECT_NEAR(robot.measure().roll, std::asin(0.08 / (lateral.trackY + lateral.flipperY)), 0.002)
        << "left side up: it stands on the left track and the pivots of the right flippers";
    const Heights truth = robot.truth();
    const TwoTrackPose& pose = robot.stance().tracks()->pose;
    const Vec2 imu = imuPosition(absolem(), pose);
    const Heights left = sideHeights(kerbLeft(0.08), absolem(), Side::Left, imu);
    const Heights right = sideHeights(kerbLeft(0.08), absolem(), Side::Right, imu);
    EXPECT_DOUBLE_EQ(truth[4], (left[4] + right[4]) / 2.0);
    EXPECT_NEAR(left[4], right[4] + 0.08, 1e-9);
}

TEST(SimulatedRobot, mirroredGroundGivesMirroredReadings)
{
    const GroundLines ground = kerbLeft(0.12);
    SimulatedRobot robot = pressedBefore(ground, 0.45);
    SimulatedRobot mirror = pressedBefore(ground.mirrored(), 0.45);
    const TwoTrackReadings s = twoTrackReadings(robot.measure());
    const TwoTrackReadings t = mirrored(twoTrackReadings(mirror.measure()));
    EXPECT_NEAR(s.roll, t.roll, 1e-6);
    for (std::size_t i = 0; i < kFlippers; ++i) EXPECT_NEAR(s.flippers[i], t.flippers[i], 1e-6);
    for (std::size_t e = 0; e < kForceElements; ++e)
        EXPECT_NEAR(*s.forces[0][e], *t.forces[0][e], 1e-3) << e;
}

TEST(SimulatedRobot, equalLinesAreTheProfile)
{
    const TerrainProfile step = stepTerrain(0.24, 3.0, 6.0);
    SimulatedRobot::Options options;
    options.startX = 1.5;
    SimulatedRobot plane(absolem(), step, options);
    SimulatedRobot lines(absolem(), GroundLines({{0.3, step}, {-0.3, step}}), options);
    const auto same = [&](double seconds) {
        for (double t = 0.0; t < seconds; t += 0.05) {
            plane.step(0.05);
            lines.step(0.05);
            ASSERT_EQ(plane.measure(), lines.measure());
        }
    };
    for (const Command& command : {Command{DriveCommand{0.3}}, Command{PressCommand{16.0}},
                                   Command{HoldFlippersCommand{0.4, 0.1}}}) {
        plane.command(command);
        lines.command(command);
        same(3.0);
    }
    const Measurement m = plane.measure();
    EXPECT_EQ(m.frontLeft, m.frontRight);
}

TEST(SimulatedRobot, probesTheSideThatItIsTold)
{
    SimulatedRobot robot = pressedBefore(kerbLeft(0.12), 0.45);
    const Measurement pressed = robot.measure();
    const auto probed = [&](ProbeSide side) {
        robot.command(ProbeCommand{8, side});
        EXPECT_TRUE(within(robot, 60.0, isPressed));
        const ArmReading reading = robot.measure().arm.value();
        EXPECT_EQ(reading.bin, 8);
        EXPECT_EQ(reading.side, side);
        EXPECT_NEAR(reading.height, robot.stance().truth(side)[8], 5.0 * absolem().armSd);
        return robot.stance().truth(side)[8];
    };
    EXPECT_NEAR(probed(ProbeSide::Left), probed(ProbeSide::Right) + 0.12, 1e-3);
    EXPECT_NEAR(probed(ProbeSide::Middle), probed(ProbeSide::Right) + 0.06, 1e-3);
    EXPECT_EQ(robot.measure().frontLeft, pressed.frontLeft) << "it did not move";
}

TEST(SimulatedRobot, refusesASideBeyondTheArmsReach)
{
    RobotModel narrow = absolem();
    narrow.armReachY = 0.25;
    SimulatedRobot::Options options;
    options.startX = 1.5;
    SimulatedRobot robot(narrow, stepTerrain(0.0, 3.0, 6.0), options);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 6.0, isPressed));
    robot.command(ProbeCommand{8, ProbeSide::Left});
    EXPECT_EQ(robot.measure().refusal, Refusal::OutOfReach);
    robot.command(ProbeCommand{8});
    EXPECT_EQ(robot.measure().activity, RobotActivity::Probing);
}

TEST(SimulatedRobot, raisesBothFlippersBeforeItDrives)
{
    SimulatedRobot robot = pressedBefore(kerbLeft(0.12), 0.45);
    const double x = robot.pose().base.x;
    robot.command(DriveCommand{-0.3});
    ASSERT_TRUE(within(robot, 6.0, [&](const Measurement&) { return robot.pose().base.x < x; }));
    EXPECT_NEAR(robot.stance().frontAngle(Side::Left), 0.7, 1e-6);
    EXPECT_NEAR(robot.stance().frontAngle(Side::Right), 0.7, 1e-6);
}

TEST(SimulatedRobot, drivesAndHaltsOnCommand)
{
    SimulatedRobot robot = robotBefore(1.5);
    const double start = robot.pose().base.x;
    robot.command(DriveCommand{0.3});
    EXPECT_FALSE(within(robot, 1.0,
                        [](const Measurement& m) { return m.activity != RobotActivity::Driving; }));
    const double driven = robot.pose().base.x - start;
    EXPECT_NEAR(driven, 0.3, 0.05);
    robot.command(HaltCommand{});
    robot.step(0.5);
    EXPECT_DOUBLE_EQ(robot.pose().base.x, start + driven);
}

TEST(SimulatedRobot, reportsTheWayOfItsTracksWithTheirSlip)
{
    const auto drivenAndReported = [](double slipShare, std::uint64_t seed) {
        SimulatedRobot::Options options;
        options.startX = 1.5;
        options.slipShare = slipShare;
        options.seed = seed;
        SimulatedRobot robot(absolem(), stepTerrain(0.0, 3.0, 6.0), options);
        EXPECT_EQ(robot.measure().travelled, 0.0);
        EXPECT_EQ(robot.measure().turned, 0.0);
        const double start = robot.pose().base.x;
        robot.command(DriveCommand{0.3});
        for (int i = 0; i < 20; ++i) robot.step(0.05);
        return std::pair(robot.pose().base.x - start, *robot.measure().travelled);
    };
    const auto [driven, exact] = drivenAndReported(0.0, 1);
    EXPECT_NEAR(exact, driven, 1e-6);
    constexpr int kDriveCount = 60;
    double squares = 0.0;
    for (int seed = 1; seed <= kDriveCount; ++seed) {
        const double slip =
            drivenAndReported(0.10, static_cast<std::uint64_t>(seed)).second / driven - 1.0;
        squares += slip * slip;
    }
    // χ² of 60 degrees of freedom lies in 32 … 103 except once in a thousand.
    EXPECT_GT(squares, 0.10 * 0.10 * 32.0);
    EXPECT_LT(squares, 0.10 * 0.10 * 103.0);
}

TEST(SimulatedRobot, reportsTheSameWayBackWithoutSlip)
{
    SimulatedRobot::Options options;
    options.startX = 2.2;
    options.slipShare = 0.0;
    SimulatedRobot robot(absolem(), stepTerrain(0.1, 3.0, 6.0), options);
    robot.command(DriveCommand{0.3});
    for (int i = 0; i < 60; ++i) robot.step(0.05);
    const double way = *robot.measure().travelled;
    EXPECT_GT(way, robot.pose().base.x - 2.2 - 0.05);
    robot.command(DriveCommand{-0.3});
    for (int i = 0; i < 60; ++i) robot.step(0.05);
    EXPECT_NEAR(*robot.measure().travelled, way - 0.9, 0.1);
}

TEST(SimulatedRobot, advancesByTheCommandedDistance)
{
    SimulatedRobot robot = robotBefore(1.5);
    const double start = robot.pose().base.x;
    robot.command(AdvanceCommand{0.1});
    EXPECT_EQ(robot.measure().activity, RobotActivity::Driving);
    ASSERT_TRUE(within(robot, 5.0,
                       [](const Measurement& m) { return m.activity == RobotActivity::Halted; }));
    EXPECT_NEAR(robot.pose().base.x - start, 0.1, 1e-9);
    EXPECT_NEAR(robot.pose().front, 1.2, 0.05) << "higher than in a drive";
    for (const double distance : {0.0, -0.05, 0.11, std::nan("")}) {
        robot.command(AdvanceCommand{distance});
        EXPECT_EQ(robot.measure().refusal, Refusal::OutOfLimits) << distance;
    }
    robot.command(DriveCommand{0.1});
    robot.command(AdvanceCommand{0.1});
    EXPECT_EQ(robot.measure().refusal, Refusal::Busy);
    robot.command(AdvanceCommand{0.1});
    robot.command(HaltCommand{});
    robot.command(DriveCommand{0.3});
    EXPECT_FALSE(within(robot, 2.0, [](const Measurement& m) {
        return m.activity != RobotActivity::Driving;
    })) << "an advance that was halted is forgotten";
}

TEST(SimulatedRobot, movesItsFlippersToTheCommandAtTheirSpeed)
{
    SimulatedRobot robot = robotBefore(1.5);
    robot.command(HoldFlippersCommand{0.3, 0.2});
    robot.step(0.1);
    EXPECT_NEAR(robot.pose().front, 0.7 - 0.0785, 1e-9);
    for (int i = 0; i < 20; ++i) robot.step(0.05);
    EXPECT_NEAR(robot.pose().front, 0.3, 1e-9);
    EXPECT_NEAR(robot.pose().rear, 0.2, 1e-9);
    EXPECT_EQ(robot.measure().activity, RobotActivity::Halted);
    for (const double angle : {-2.0, 3.2, std::nan("")}) {
        robot.command(HoldFlippersCommand{angle, 0.0});
        EXPECT_EQ(robot.measure().refusal, Refusal::OutOfLimits) << angle;
        robot.command(HoldFlippersCommand{0.0, angle});
        EXPECT_EQ(robot.measure().refusal, Refusal::OutOfLimits) << angle;
    }
}

TEST(SimulatedRobot, haltsWhenAnExplorationBeginsOrEnds)
{
    SimulatedRobot robot = robotBefore(1.5);
    for (const Command& command : {Command{BeginAtemCommand{}}, Command{AbortAtemCommand{}}}) {
        robot.command(DriveCommand{0.3});
        robot.command(command);
        EXPECT_EQ(robot.measure().activity, RobotActivity::Halted);
        EXPECT_EQ(robot.measure().refusal, Refusal::None);
    }
    robot.command(ArmCommand{true});
    EXPECT_EQ(robot.measure().refusal, Refusal::None);
    robot.command(DriveCommand{std::nan("")});
    EXPECT_EQ(robot.measure().refusal, Refusal::OutOfLimits);
}

TEST(SimulatedRobot, pressesUntilTheTorqueIsReached)
{
    SimulatedRobot robot = robotBefore(0.5);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 10.0, isPressed));
    EXPECT_NEAR(robot.stance().frontTorque(Side::Left), 8.0, 0.005);
    EXPECT_GT(robot.pose().front, 0.2);  // on the step's edge, not through it
}

TEST(SimulatedRobot, stopsPressingWhereThereIsNoGround)
{
    SimulatedRobot robot = robotBefore(0.15, -1.0);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 10.0, isPressed));
    EXPECT_NEAR(robot.pose().front, kLowestFlipper, 1e-9);
}

TEST(SimulatedRobot, probesOnlyWhenPressedAndWithinReach)
{
    SimulatedRobot robot = robotBefore(0.5);
    robot.command(ProbeCommand{9});
    EXPECT_EQ(robot.measure().refusal, Refusal::NotPressed);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 10.0, isPressed));
    robot.command(ProbeCommand{2});
    EXPECT_EQ(robot.measure().refusal, Refusal::OutOfReach);
    robot.command(ProbeCommand{9});
    EXPECT_EQ(robot.measure().activity, RobotActivity::Probing);
    ASSERT_TRUE(within(robot, 3.0, [](const Measurement& m) { return m.arm.has_value(); }));
    EXPECT_NEAR(robot.measure().arm->height, robot.truth()[9], 0.15);  // 5 sd
    EXPECT_EQ(robot.measure().arm->bin, 9);
}

TEST(SimulatedRobot, latchesStop)
{
    SimulatedRobot robot = robotBefore(1.5);
    robot.command(DriveCommand{0.3});
    robot.step(0.1);
    robot.command(StopCommand{});
    const double x = robot.pose().base.x;
    robot.command(DriveCommand{0.3});
    EXPECT_EQ(robot.measure().refusal, Refusal::StopLatched);
    robot.step(0.5);
    EXPECT_DOUBLE_EQ(robot.pose().base.x, x);
    robot.command(ReleaseStopCommand{});
    EXPECT_EQ(robot.measure().activity, RobotActivity::Halted);
}

TEST(SimulatedRobot, forgetsTheArmsReadingWhenItMoves)
{
    SimulatedRobot robot = robotBefore(0.5);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 10.0, isPressed));
    robot.command(ProbeCommand{10});
    ASSERT_TRUE(within(robot, 3.0, [](const Measurement& m) { return m.arm.has_value(); }));
    robot.command(DriveCommand{-0.2});
    robot.step(0.1);
    EXPECT_FALSE(robot.measure().arm.has_value());
}

TEST(SimulatedRobot, repeatsItselfForASeed)
{
    SimulatedRobot a = robotBefore(0.5);
    SimulatedRobot b = robotBefore(0.5);
    a.command(PressCommand{16.0});
    b.command(PressCommand{16.0});
    for (int k = 0; k < 60; ++k) {
        a.step(0.05);
        b.step(0.05);
        EXPECT_EQ(a.measure(), b.measure());
    }
}

TEST(SimulatedRobot, refusesImpossibleTime)
{
    SimulatedRobot robot = robotBefore(1.5);
    EXPECT_THROW(robot.step(0.0), std::invalid_argument);
    EXPECT_THROW(robot.step(2.0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
