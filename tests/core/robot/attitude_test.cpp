#include "core/robot/attitude.h"
#include "tests/support/absolem.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terratact {
namespace {

constexpr double kDegree = 0.017453292519943295;

Measurement tilted(double pitch, double roll)
{
    Measurement m;
    m.pitch = pitch * kDegree;
    m.roll = roll * kDegree;
    m.frontLeft = m.frontRight = m.rearLeft = m.rearRight = 0.7;
    return m;
}

TEST(TipOver, IsWhereTheMassStandsOverTheLastSupport)
{
    // Flippers flat: the whole robot's centre of mass is at (-0.031, 0.108), the robot file says.
    RobotModel robot = absolem();
    robot.front.axleDistance = robot.rear.axleDistance = 1e-9;  // no tips that carry
    robot.front.comDistance = robot.rear.comDistance = 0.0;
    robot.front.tipRadius = robot.rear.tipRadius = 0.0;
    const TipOver tips = tipOver(robot, 0.0, 0.0);
    const double ground = robot.trackZ - robot.trackRadius, total = robot.totalMass();
    const double x = robot.bodyMass * robot.bodyCom.x / total;
    const double z = (robot.bodyMass * robot.bodyCom.z + 3.0 * 0.0195) / total;
    EXPECT_NEAR(std::tan(tips.noseUp), (x + 0.25) / (z - ground), 1e-6);
    EXPECT_NEAR(std::tan(tips.noseDown), (0.25 - x) / (z - ground), 1e-6);
    EXPECT_NEAR(std::tan(tips.leftUp), robot.halfWidth / (z - ground), 1e-6);
    EXPECT_DOUBLE_EQ(tips.leftUp, tips.rightUp);
}

TEST(TipOver, AHeavySideTipsTheRobotEarlier)
{
    RobotModel robot = absolem();
    robot.lateral.bodyComY = 0.15;
    const double aside = robot.bodyMass * 0.15 / robot.totalMass();
    const TipOver even = tipOver(absolem(), 0.0, 0.0), tips = tipOver(robot, 0.0, 0.0);
    const double height = robot.halfWidth / std::tan(even.leftUp);
    EXPECT_NEAR(std::tan(tips.leftUp), (robot.halfWidth + aside) / height, 1e-9);
    EXPECT_NEAR(std::tan(tips.rightUp), (robot.halfWidth - aside) / height, 1e-9);
    const double roll = tips.rightUp / kDegree;
    const AttitudeLimits wide{80.0 * kDegree, 80.0 * kDegree};
    EXPECT_TRUE(attitudeOf(tilted(0.0, -roll - 1.0), robot, wide).beyondTipping);
    EXPECT_FALSE(attitudeOf(tilted(0.0, roll + 1.0), robot, wide).beyondTipping);
    EXPECT_EQ(attitudeOf(tilted(0.0, 11.0 - roll), robot, wide).roll, AttitudeLevel::Amber);
    EXPECT_EQ(attitudeOf(tilted(0.0, 9.0 - roll), robot, wide).roll, AttitudeLevel::Red);
}

TEST(TipOver, FlippersOnTheGroundHoldTheRobotLonger)
{
    const TipOver raised = tipOver(absolem(), 0.7, 0.7), flat = tipOver(absolem(), 0.0, 0.0);
    EXPECT_GT(flat.noseUp, raised.noseUp + 0.2);
    EXPECT_GT(flat.noseDown, raised.noseDown + 0.2);
    EXPECT_NEAR(raised.noseUp, 50.0 * kDegree, 3.0 * kDegree);
}

TEST(Attitude, IsJudgedByTheOperatorsLimits)
{
    const AttitudeLimits limits{20.0 * kDegree, 30.0 * kDegree};
    EXPECT_EQ(attitudeOf(tilted(19.0, 0.0), absolem(), limits).worst(), AttitudeLevel::Level);
    EXPECT_EQ(attitudeOf(tilted(-21.0, 0.0), absolem(), limits).pitch, AttitudeLevel::Amber);
    EXPECT_EQ(attitudeOf(tilted(31.0, -21.0), absolem(), limits).pitch, AttitudeLevel::Red);
    EXPECT_EQ(attitudeOf(tilted(31.0, -21.0), absolem(), limits).roll, AttitudeLevel::Amber);
}

TEST(Attitude, DistinguishesTipOverFromItsReserve)
{
    EXPECT_FALSE(attitudeOf(tilted(45.0, 0.0), absolem(), {}).beyondTipping);
    EXPECT_TRUE(attitudeOf(tilted(60.0, 0.0), absolem(), {}).beyondTipping);
    EXPECT_TRUE(attitudeOf(tilted(-75.0, 0.0), absolem(), {}).beyondTipping);
    EXPECT_TRUE(attitudeOf(tilted(0.0, 75.0), absolem(), {}).beyondTipping);
}

TEST(Attitude, IsRedNearTippingOverForAnyLimits)
{
    const AttitudeLimits wide{80.0 * kDegree, 80.0 * kDegree};
    EXPECT_EQ(attitudeOf(tilted(60.0, 0.0), absolem(), wide).pitch, AttitudeLevel::Red);
    EXPECT_EQ(attitudeOf(tilted(-68.0, 0.0), absolem(), wide).pitch, AttitudeLevel::Red);
    EXPECT_EQ(attitudeOf(tilted(0.0, 50.0), absolem(), wide).roll, AttitudeLevel::Red);
    EXPECT_EQ(attitudeOf(tilted(34.0, 0.0), absolem(), wide).pitch, AttitudeLevel::Amber);
    EXPECT_EQ(attitudeOf(tilted(10.0, 10.0), absolem(), wide).worst(), AttitudeLevel::Level);
    EXPECT_LT(attitudeOf(tilted(-68.0, 0.0), absolem(), wide).pitchTips, 0.0);
}

TEST(Attitude, TakesTheWidthOfTheRobotFile)
{
    EXPECT_DOUBLE_EQ(absolem().halfWidth, 0.1985 + 0.097 / 2.0);
    RobotModel narrow = absolem();
    narrow.halfWidth = 0.05;
    EXPECT_EQ(attitudeOf(tilted(0.0, 12.0), narrow, {}).roll, AttitudeLevel::Red);
}

}  // namespace
}  // namespace terratact
