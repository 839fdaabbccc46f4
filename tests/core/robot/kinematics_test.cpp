#include "core/robot/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns the hull's lower boundary by brute force: the least z over a dense set of discs between
/// the two circles.
double sweptBottom(const TaperedHull& hull, double x)
{
    double lowest = kInfinity;
    constexpr int kDiscs = 200000;
    for (int k = 0; k <= kDiscs; ++k) {
        const double t = static_cast<double>(k) / kDiscs;
        const double dx = x - (hull.a.x + t * (hull.b.x - hull.a.x));
        const double r = hull.ra + t * (hull.rb - hull.ra);
        if (std::abs(dx) > r) continue;
        lowest =
            std::min(lowest, hull.a.z + t * (hull.b.z - hull.a.z) - std::sqrt(r * r - dx * dx));
    }
    return lowest;
}

TEST(LowerBoundary, isTheBottomOfAllDiscsBetweenTheTwoCircles)
{
    for (const double angle : {-2.5, -1.0, -0.2, 0.0, 0.7, 1.5707, 3.0}) {
        const TaperedHull hull{
            {0.1, 0.2}, {0.1 + 0.3 * std::cos(angle), 0.2 + 0.3 * std::sin(angle)}, 0.09, 0.03};
        for (double x = -0.4; x < 0.6; x += 0.037) {
            const double expected = sweptBottom(hull, x);
            const double got = lowerBoundary(hull, x);
            if (std::isinf(expected))
                EXPECT_EQ(got, expected) << "angle " << angle << " x " << x;
            else
                EXPECT_NEAR(got, expected, 1e-5) << "angle " << angle << " x " << x;
        }
    }
}

TEST(LowerBoundary, ofAPolygonIsItsLowestEdge)
{
    const std::vector<Vec2> box{{-1.0, 0.5}, {1.0, 0.5}, {1.0, 1.0}, {-1.0, 1.0}};
    EXPECT_DOUBLE_EQ(lowerBoundary(box, 0.3), 0.5);
    EXPECT_EQ(lowerBoundary(box, 1.1), kInfinity);
}

TEST(Flipper, atJointZeroLiesFlatWithTheTracksLowerEdge)
{
    const RobotModel robot = absolem();
    const RobotShape shape = shapeAt(robot, {});
    for (double x = 0.26; x < 0.56; x += 0.02)
        EXPECT_NEAR(lowerBoundary(shape.front, x), -robot.baseHeight, 2e-4);
    for (double x = -0.26; x > -0.56; x -= 0.02)
        EXPECT_NEAR(lowerBoundary(shape.rear, x), -robot.baseHeight, 2e-4);
    EXPECT_NEAR(shape.front.b.x + shape.front.rb, 0.59,
                0.005);  // the paper's tip: just inside bin 0.6
}

TEST(Flipper, frontAndRearTipsRiseWithAPositiveAngle)
{
    const RobotModel robot = absolem();
    const RobotShape flat = shapeAt(robot, {});
    const RobotShape raised = shapeAt(robot, {.base = {}, .pitch = 0.0, .front = 0.4, .rear = 0.4});
    EXPECT_GT(raised.front.b.z, flat.front.b.z + 0.1);
    EXPECT_GT(raised.rear.b.z, flat.rear.b.z + 0.1);
    EXPECT_NEAR(raised.front.b.x, -raised.rear.b.x, 1e-12);  // mirror images
}

TEST(Pitch, noseUpLiftsTheFrontAndLowersTheRear)
{
    const RobotModel robot = absolem();
    const RobotShape shape = shapeAt(robot, {.base = {}, .pitch = 0.3, .front = 0.0, .rear = 0.0});
    EXPECT_GT(shape.front.a.z, shape.rear.a.z + 0.1);
}

TEST(DemFrame, hasItsOriginAtTheImu)
{
    const RobotModel robot = absolem();
    for (const double pitch : {-0.5, 0.0, 0.8}) {
        const Vec2 imu = imuPosition(robot, poseInDem(robot, pitch, 0.1, 0.2));
        EXPECT_NEAR(imu.x, 0.0, 1e-15);
        EXPECT_NEAR(imu.z, 0.0, 1e-15);
    }
    EXPECT_NEAR(lowerEnvelope(shapeAt(robot, poseInDem(robot, 0.0, 0.0, 0.0)), 0.0), -0.240, 0.001);
}

TEST(ForceElements, lieOnTheFlippersLowerEdge)
{
    const RobotModel robot = absolem();
    for (const double angle : {-0.6, 0.0, 0.9}) {
        const Pose pose = poseInDem(robot, 0.15, angle, 0.0);
        const RobotShape shape = shapeAt(robot, pose);
        for (const double share : robot.elementShare) {
            const Vec2 p = elementPosition(robot, pose, share);
            EXPECT_NEAR(lowerBoundary(shape.front, p.x), p.z, 1e-9)
                << "angle " << angle << " share " << share;
        }
    }
}

}  // namespace
}  // namespace terratact
