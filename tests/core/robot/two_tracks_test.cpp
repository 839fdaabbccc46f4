#include "core/robot/two_tracks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

struct Point {
    double x, y, z;
};

/// Returns x and z of a body's point: rolled about x, then pitched about y.
Vec2 rigid(const TwoTrackPose& pose, Point p)
{
    const double up = p.y * std::sin(pose.roll) + p.z * std::cos(pose.roll);
    const Vec2 r = rotated({p.x, up}, pose.pitch);
    return {pose.base.x + r.x, pose.base.z + r.z};
}

TEST(TwoTracks, sidePoseHasTheLowerEdgeOfTheRigidRobot)
{
    const RobotModel robot = absolem();
    const double edge = robot.trackZ - robot.trackRadius;
    for (const double pitch : {-0.4, 0.0, 0.3})
        for (const double roll : {-0.3, 0.0, 0.2}) {
            const TwoTrackPose pose{.base = {1.0, 0.5}, .pitch = pitch, .roll = roll};
            for (const Side side : {Side::Left, Side::Right}) {
                const Pose plane = sidePose(robot, pose, side, 0.1985);
                for (const double x : {-0.25, 0.25}) {
                    const Vec2 expected = rigid(pose, {x, signOf(side) * 0.1985, edge});
                    const Vec2 got = toWorld(plane, {x, edge});
                    EXPECT_NEAR(got.x, expected.x, 1e-12);
                    EXPECT_NEAR(got.z, expected.z, 1e-12);
                }
            }
        }
}

TEST(TwoTracks, theImuIsThatOfTheRigidRobot)
{
    const RobotModel robot = absolem();
    const TwoTrackPose pose{.base = {1.0, 0.5}, .pitch = 0.2, .roll = -0.3};
    const Vec2 expected = rigid(pose, {robot.imu.x, 0.0, robot.imu.z});
    const Vec2 imu = imuPosition(robot, pose);
    EXPECT_NEAR(imu.x, expected.x, 1e-12);
    EXPECT_NEAR(imu.z, expected.z, 1e-12);
}

TEST(TwoTracks, withoutRollAreThePlane)
{
    const RobotModel robot = absolem();
    const TwoTrackPose pose{.base = {1.0, 0.5}, .pitch = 0.2, .flippers = {0.1, 0.2, 0.3, 0.4}};
    const Pose left = sidePose(robot, pose, Side::Left, 0.272);
    EXPECT_EQ(left.base, pose.base);
    EXPECT_EQ(left.pitch, 0.2);
    EXPECT_EQ(left.front, 0.1);
    EXPECT_EQ(left.rear, 0.3);
    const Vec2 plane = imuPosition(robot, left), tracks = imuPosition(robot, pose);
    EXPECT_EQ(plane, tracks);
}

TEST(TwoTracks, theDifferentialPitchesTheTracksAgainstEachOther)
{
    const TwoTrackPose pose{.base = {}, .pitch = 0.1, .differential = 0.2};
    EXPECT_DOUBLE_EQ(sidePose(absolem(), pose, Side::Left, 0.2).pitch, 0.1 + 0.2);
    EXPECT_DOUBLE_EQ(sidePose(absolem(), pose, Side::Right, 0.2).pitch, 0.1 - 0.2);
}

TEST(TwoTracks, mirroredExchangesLeftAndRight)
{
    TwoTrackReadings readings;
    readings.pitch = 0.1;
    readings.roll = 0.2;
    readings.flippers = {1.0, 2.0, 3.0, 4.0};
    readings.differential = 0.05;
    readings.currents = {1.0, std::nullopt, 3.0, 4.0};
    readings.forces[0][5] = 7.0;
    const TwoTrackReadings mirror = mirrored(readings);
    EXPECT_EQ(mirror.pitch, 0.1);
    EXPECT_EQ(mirror.roll, -0.2);
    EXPECT_EQ(mirror.flippers, (PerFlipper<double>{2.0, 1.0, 4.0, 3.0}));
    EXPECT_EQ(mirror.differential, -0.05);
    EXPECT_FALSE(mirror.currents[0]);
    EXPECT_EQ(mirror.currents[2], 4.0);
    EXPECT_EQ(mirror.forces[1][5], 7.0);
    EXPECT_EQ(mirrored(mirror), readings);

    const TwoTrackPose pose{.base = {1.0, 2.0},
                            .pitch = 0.1,
                            .roll = 0.2,
                            .flippers = {1.0, 2.0, 3.0, 4.0},
                            .differential = 0.3};
    EXPECT_EQ(mirrored(pose).roll, -0.2);
    EXPECT_EQ(mirrored(pose).differential, -0.3);
    EXPECT_EQ(mirrored(mirrored(pose)), pose);
}

/// Returns a line of telemetry in which all values of the sides differ.
Measurement differentSides()
{
    Measurement m;
    m.pitch = 0.1, m.roll = -0.2;
    m.frontLeft = 0.3, m.frontRight = 0.4, m.rearLeft = 0.5, m.rearRight = 0.6;
    m.frontLeftCurrent = 1.0, m.frontRightCurrent = 2.0;
    m.rearLeftCurrent = 3.0, m.rearRightCurrent = 4.0;
    SideForces front;
    for (std::size_t e = 0; e < kForceElements; ++e) {
        front.left[e] = 10.0 + static_cast<double>(e);
        front.right[e] = 20.0 + static_cast<double>(e);
    }
    front.right[2].reset();
    setSides(m, front);
    m.rearSides.left[5] = 7.0;
    m.differential = 0.05;
    return m;
}

TEST(TwoTrackReadings, keepBothSidesOfALine)
{
    const TwoTrackReadings s = twoTrackReadings(differentSides());
    EXPECT_EQ(s.pitch, 0.1);
    EXPECT_EQ(s.roll, -0.2);
    EXPECT_EQ(s.flippers, (PerFlipper<double>{0.3, 0.4, 0.5, 0.6}));
    EXPECT_EQ(s.currents, (PerFlipper<std::optional<double>>{1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(s.differential, 0.05);
    EXPECT_EQ(s.forces[indexOf(Flipper::FrontLeft)][2], 12.0);
    EXPECT_EQ(s.forces[indexOf(Flipper::FrontRight)][1], 21.0);
    EXPECT_FALSE(s.forces[indexOf(Flipper::FrontRight)][2]) << "it is not known, not equal";
    EXPECT_EQ(s.forces[indexOf(Flipper::RearLeft)][5], 7.0);
    EXPECT_FALSE(s.forces[indexOf(Flipper::RearRight)][5]);
}

TEST(TwoTrackReadings, lackWhatWasNotMeasured)
{
    Measurement m = differentSides();
    m.missing[kFrontCurrentFeature] = true;
    m.sides = {};  // as in an older session: the means alone
    m.differential.reset();
    const TwoTrackReadings s = twoTrackReadings(m);
    EXPECT_FALSE(s.currents[0] || s.currents[1]);
    EXPECT_TRUE(s.currents[2] && s.currents[3]);
    EXPECT_FALSE(s.differential);
    for (const auto& force : s.forces[0]) EXPECT_FALSE(force);
}

TEST(TwoTrackReadings, becomeALineAndComeBack)
{
    const Measurement m = differentSides();
    EXPECT_EQ(measurementOf(twoTrackReadings(m)), m);
    Measurement lacking = m;
    lacking.missing[kRearCurrentFeature] = true;
    lacking.rearLeftCurrent = lacking.rearRightCurrent = 0.0;
    EXPECT_EQ(measurementOf(twoTrackReadings(lacking)), lacking);
    for (std::size_t motor = 0; motor < kMotors; ++motor) {
        TwoTrackReadings s = twoTrackReadings(m);
        s.currents[motor].reset();
        EXPECT_EQ(twoTrackReadings(measurementOf(s)), s) << motor;
    }
}

}  // namespace
}  // namespace terratact
