#include "core/terrain/kinematic_reconstruction.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/robot/kinematics.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

Proprioception feeling(std::array<double, kForceElements> force, double front = 0.3)
{
    Proprioception s;
    s.front = front;
    for (std::size_t e = 0; e < force.size(); ++e) s.force[e] = force[e];
    return s;
}

int known(const KinematicReconstruction& r)
{
    int n = 0;
    for (const auto& h : r.height) n += h.has_value() ? 1 : 0;
    return n;
}

TEST(IsolatedContact, isOneElementAboveTheThreshold)
{
    const RobotModel robot = absolem();
    const auto r = reconstructContacts(robot, feeling({0, 0, 0, 0, 5, 0}), 2.0, true);
    ASSERT_EQ(r.contacts.size(), 1U);
    const Vec2 p = elementPosition(robot, poseInDem(robot, 0.0, 0.3, 0.0), robot.elementShare[4]);
    EXPECT_DOUBLE_EQ(r.contacts[0].x, p.x);
    EXPECT_DOUBLE_EQ(*r.height[static_cast<std::size_t>(*binOf(p.x))], p.z);
    EXPECT_EQ(known(r), 1);
}

TEST(IsolatedContact, ofNeighboursIsTheirForceWeightedCentre)
{
    const RobotModel robot = absolem();
    const auto r = reconstructContacts(robot, feeling({0, 0, 0, 3, 9, 0}), 2.0, true);
    ASSERT_EQ(r.contacts.size(), 1U);
    const double share = (3 * robot.elementShare[3] + 9 * robot.elementShare[4]) / 12;
    EXPECT_NEAR(r.contacts[0].x, elementPosition(robot, poseInDem(robot, 0.0, 0.3, 0.0), share).x,
                1e-12);
    EXPECT_TRUE(r.touching[3] && r.touching[4] && !r.touching[5]);
}

TEST(IsolatedContact, isNoneWhenTwoGroupsTouch)
{
    const auto r = reconstructContacts(absolem(), feeling({4, 0, 0, 0, 0, 4}), 2.0, true);
    EXPECT_TRUE(r.contacts.empty());
    EXPECT_EQ(known(r), 0);
}

TEST(AnyContact, fixesABinPerElementAboveTheThreshold)
{
    const auto r = reconstructContacts(absolem(), feeling({0, 4, 0, 0, 0, 4}), 2.0, false);
    EXPECT_EQ(r.contacts.size(), 2U);
    EXPECT_EQ(known(r), 2);
}

TEST(Contact, atTheThresholdOrUnknownIsNone)
{
    Proprioception s = feeling({0, 0, 2.0, 0, 0, 0});
    EXPECT_EQ(known(reconstructContacts(absolem(), s, 2.0, false)), 0);
    s.force[2].reset();
    EXPECT_EQ(known(reconstructContacts(absolem(), s, 0.0, false)), 0);
    EXPECT_THROW((void)reconstructContacts(absolem(), s, -1.0, false), std::invalid_argument);
}

TEST(Contact, aboveTheRobotsOwnBodyIsNamed)
{
    // The flippers are folded back over the tracks: their contacts cannot be ground.
    const auto r = reconstructContacts(absolem(), feeling({0, 0, 0, 0, 0, 8}, 2.6), 2.0, true);
    ASSERT_EQ(r.warnings.size(), 1U);
    EXPECT_NE(r.warnings[0].english().find("above the robot's own lower edge"), std::string::npos)
        << r.warnings[0].english();
}

TEST(Contact, onAStepsEdgeIsWhereTheSimulatorTouchesIt)
{
    const RobotModel robot = absolem();
    const double edge = 3.0;
    const TerrainProfile terrain = stepTerrain(0.24, edge, 6.0);
    for (const double x : {2.45, 2.5, 2.55}) {
        const auto rest = restPose(robot, terrain, x, PressTorque{12.0}, HoldAngle{0.2});
        ASSERT_TRUE(rest);
        const auto r = reconstructContacts(robot, exactReadings(robot, *rest), 2.0, true);
        ASSERT_EQ(r.contacts.size(), 1U) << x;
        const Vec2 imu = imuPosition(robot, rest->pose);
        EXPECT_NEAR(r.contacts[0].x + imu.x, edge, 0.02) << x;
        EXPECT_NEAR(r.contacts[0].height + imu.z, 0.24, 0.02) << x;
    }
}

}  // namespace
}  // namespace terratact
