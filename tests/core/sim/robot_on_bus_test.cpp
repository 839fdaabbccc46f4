#include "core/sim/robot_on_bus.h"

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

#include "core/sim/ground/terrain_shapes.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Returns what a console receives of a robot with exact sensors whose left side stands on a kerb.
std::optional<Measurement> heardOnAKerb(const RobotModel& robot, const RobotModel& assumed,
                                        std::string_view fault = {})
{
    const GroundLines kerb(
        {{0.2, stepTerrain(0.08, 1.0, 6.0)}, {-0.2, stepTerrain(0.0, 1.0, 6.0)}});
    SimulatedRobot::Options options;
    options.startX = 3.0;
    options.noise = SensorNoise::none();
    RobotOnBus onBus(robot, SimulatedRobot(robot, kerb, options),
                     {.sensorFault = sensorFaultFrom(fault)});
    TelemetryListener listener(assumed);
    std::optional<Measurement> heard;
    for (int line = 0; line < 20; ++line) {
        const double now = 0.05 * line;
        for (const CanFrame& frame : onBus.tick(now))
            if (const auto measured = listener.receive(frame, now)) heard = measured;
    }
    return heard;
}

TEST(RobotOnBus, sendsBothSidesOfItsGround)
{
    const RobotModel robot = absolem();
    const auto m = heardOnAKerb(robot, robot);
    ASSERT_TRUE(m);
    EXPECT_GT(m->roll, 0.15) << "left side up";
    EXPECT_EQ(m->rearSides, SideForces{});
    EXPECT_FALSE(m->differential);
    const TwoTrackReadings s = twoTrackReadings(*m);
    for (const Flipper flipper : {Flipper::FrontLeft, Flipper::FrontRight})
        for (const auto& force : s.forces[indexOf(flipper)]) EXPECT_TRUE(force);
    for (const auto& current : s.currents) EXPECT_TRUE(current);
}

TEST(RobotOnBus, saysWhichSensorsAreLost)
{
    const RobotModel robot = absolem();
    const auto heardWith = [&robot](std::string_view fault) {
        return heardOnAKerb(robot, robot, fault).value_or(Measurement{});
    };
    const MotorCurrents currents = motorCurrents(heardWith("lost:front-left-current"));
    EXPECT_FALSE(currents[0]);
    EXPECT_TRUE(currents[1] && currents[2] && currents[3]);
    const Measurement side = heardWith("lost:left-force-6");
    EXPECT_FALSE(side.sides.left[5]);
    EXPECT_TRUE(side.sides.right[5]);
    EXPECT_TRUE(side.missing.none());
    EXPECT_TRUE(heardWith("lost:force-6").missing[kFirstForceFeature + 5]);
    EXPECT_FALSE(heardWith("lost:odometry").travelled);
    const Measurement least = heardWith("lost:all");
    EXPECT_EQ(least.missing.count(), 8U) << "two axles, six elements";
    EXPECT_GT(least.roll, 0.15) << "the pose is there";
}

TEST(RobotOnBus, sendsRearForcesAndTheDifferentialOfItsFile)
{
    RobotModel robot = absolem();
    robot.rearElementShare = robot.elementShare;
    robot.differential.locked = false;
    const auto m = heardOnAKerb(robot, robot);
    ASSERT_TRUE(m);
    EXPECT_TRUE(m->differential);
    for (std::size_t e = 0; e < kForceElements; ++e)
        EXPECT_TRUE(m->rearSides.left[e] && m->rearSides.right[e]) << e;
    EXPECT_TRUE(heardOnAKerb(robot, absolem())) << "a console whose file lacks them";
    EXPECT_FALSE(heardOnAKerb(absolem(), robot)) << "a robot that does not send them";
}

}  // namespace
}  // namespace terratact
