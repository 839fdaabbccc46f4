#include "core/robot/side_plane.h"

#include <gtest/gtest.h>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

TwoTrackReadings evenReadings()
{
    TwoTrackReadings s;
    s.pitch = 0.1;
    s.flippers = {0.3, 0.3, -0.2, -0.2};
    s.currents = {1.0, 1.0, 2.0, 2.0};
    for (const Flipper front : {Flipper::FrontLeft, Flipper::FrontRight})
        s.forces[indexOf(front)] = {5.0, 4.0, 3.0, 2.0, 1.0, 0.0};
    return s;
}

TEST(SidePlane, isTheSidesPlaneInTheDemFrame)
{
    const RobotModel robot = absolem();
    TwoTrackPose pose{.base = {}, .pitch = 0.2, .roll = -0.15, .flippers = {0.3, 0.1, 0.0, 0.2}};
    const Vec2 imu = imuPosition(robot, pose);
    pose.base = {-imu.x, -imu.z};
    for (const Side side : {Side::Left, Side::Right}) {
        const double y = robot.lateral.flipperY;
        const Pose expected = sidePose(robot, pose, side, y);
        const Pose found = poseInDem(inSidePlane(robot, pose.roll, signOf(side) * y), pose.pitch,
                                     expected.front, expected.rear);
        EXPECT_NEAR(found.base.x, expected.base.x, 1e-12);
        EXPECT_NEAR(found.base.z, expected.base.z, 1e-12);
    }
    EXPECT_EQ(inSidePlane(robot, 0.0, 0.2).imu, robot.imu);
}

TEST(SidePlane, aPlaneReadsTheMeanOfWhatIsThere)
{
    TwoTrackReadings s = evenReadings();
    s.flippers = {0.3, 0.1, -0.2, 0.0};
    s.currents[indexOf(Flipper::FrontRight)].reset();
    s.forces[indexOf(Flipper::FrontRight)][0] = 7.0;
    s.forces[indexOf(Flipper::FrontRight)][5].reset();
    const Proprioception mean = planeReadings(s);
    EXPECT_DOUBLE_EQ(mean.front, 0.2);
    EXPECT_DOUBLE_EQ(mean.rear, -0.1);
    EXPECT_EQ(mean.frontCurrent, 1.0);
    EXPECT_EQ(mean.rearCurrent, 2.0);
    EXPECT_EQ(mean.force[0], 6.0);
    EXPECT_EQ(mean.force[5], 0.0);
}

TEST(SidePlane, aDifferentialTurnsBeyondItsSensorsNoise)
{
    EXPECT_FALSE(hasTurned(std::nullopt));
    EXPECT_FALSE(hasTurned(-kTurnedDifferential));
    EXPECT_TRUE(hasTurned(-1.01 * kTurnedDifferential));
}

TEST(SidePlane, isSymmetricWithinTheNoiseOnly)
{
    EXPECT_TRUE(isSymmetric(evenReadings()));
    TwoTrackReadings s = evenReadings();
    s.roll = 0.02;
    s.flippers[0] += 0.005;
    s.forces[0][0] = 6.0;
    EXPECT_TRUE(isSymmetric(s));
    s.roll = 0.03;
    EXPECT_FALSE(isSymmetric(s));
    s = evenReadings();
    s.flippers[indexOf(Flipper::RearLeft)] += 0.01;
    EXPECT_FALSE(isSymmetric(s));
    s = evenReadings();
    s.currents[indexOf(Flipper::RearRight)] = 2.5;
    EXPECT_FALSE(isSymmetric(s));
    s = evenReadings();
    s.forces[indexOf(Flipper::FrontRight)][5] = 2.0;
    EXPECT_FALSE(isSymmetric(s));
    s.forces[indexOf(Flipper::FrontRight)][5].reset();  // one side alone has it
    EXPECT_FALSE(isSymmetric(s));
}

TEST(SidePlane, aReadingOfOneSideMakesNoDifference)
{
    TwoTrackReadings s = evenReadings();
    s.currents[indexOf(Flipper::FrontLeft)].reset();
    s.forces[indexOf(Flipper::FrontRight)][5].reset();
    EXPECT_FALSE(sidesDiffer(s));
    EXPECT_FALSE(isSymmetric(s));
    s.currents[indexOf(Flipper::RearRight)] = 2.5;
    EXPECT_TRUE(sidesDiffer(s));
}

}  // namespace
}  // namespace terratact
