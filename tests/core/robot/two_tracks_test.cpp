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

}  // namespace
}  // namespace terratact
