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

TEST(SimulatedRobot, drivesAndHaltsOnCommand)
{
    SimulatedRobot robot = robotBefore(1.5);
    const double start = robot.rest().pose.base.x;
    robot.command(DriveCommand{0.3});
    EXPECT_FALSE(within(robot, 1.0,
                        [](const Measurement& m) { return m.activity != RobotActivity::Driving; }));
    const double driven = robot.rest().pose.base.x - start;
    EXPECT_NEAR(driven, 0.3, 0.05);
    robot.command(HaltCommand{});
    robot.step(0.5);
    EXPECT_DOUBLE_EQ(robot.rest().pose.base.x, start + driven);
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
        const double start = robot.rest().pose.base.x;
        robot.command(DriveCommand{0.3});
        for (int i = 0; i < 20; ++i) robot.step(0.05);
        return std::pair(robot.rest().pose.base.x - start, *robot.measure().travelled);
    };
    const auto [driven, exact] = drivenAndReported(0.0, 1);
    EXPECT_NEAR(exact, driven, 1e-6);
    constexpr int kDrives = 60;
    double squares = 0.0;
    for (int seed = 1; seed <= kDrives; ++seed) {
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
    EXPECT_GT(way, robot.rest().pose.base.x - 2.2 - 0.05);
    robot.command(DriveCommand{-0.3});
    for (int i = 0; i < 60; ++i) robot.step(0.05);
    EXPECT_NEAR(*robot.measure().travelled, way - 0.9, 0.1);
}

TEST(SimulatedRobot, advancesByTheCommandedDistance)
{
    SimulatedRobot robot = robotBefore(1.5);
    const double start = robot.rest().pose.base.x;
    robot.command(AdvanceCommand{0.1});
    EXPECT_EQ(robot.measure().activity, RobotActivity::Driving);
    ASSERT_TRUE(within(robot, 5.0,
                       [](const Measurement& m) { return m.activity == RobotActivity::Halted; }));
    EXPECT_NEAR(robot.rest().pose.base.x - start, 0.1, 1e-9);
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
    EXPECT_NEAR(robot.rest().pose.front, 0.7 - 0.0785, 1e-9);
    for (int i = 0; i < 20; ++i) robot.step(0.05);
    EXPECT_NEAR(robot.rest().pose.front, 0.3, 1e-9);
    EXPECT_NEAR(robot.rest().pose.rear, 0.2, 1e-9);
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
    EXPECT_NEAR(robot.rest().frontTorque, 16.0, 0.01);
    EXPECT_GT(robot.rest().pose.front, 0.2);  // on the step's edge, not through it
}

TEST(SimulatedRobot, stopsPressingWhereThereIsNoGround)
{
    SimulatedRobot robot = robotBefore(0.15, -1.0);
    robot.command(PressCommand{16.0});
    ASSERT_TRUE(within(robot, 10.0, isPressed));
    EXPECT_NEAR(robot.rest().pose.front, kLowestFlipper, 1e-9);
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
    const double x = robot.rest().pose.base.x;
    robot.command(DriveCommand{0.3});
    EXPECT_EQ(robot.measure().refusal, Refusal::StopLatched);
    robot.step(0.5);
    EXPECT_DOUBLE_EQ(robot.rest().pose.base.x, x);
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
