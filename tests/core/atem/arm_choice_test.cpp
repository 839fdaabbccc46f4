#include "core/atem/arm_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace terratact {
namespace {

constexpr int kBin05 = 8, kBin06 = 9, kBin07 = 10;

/// The arm reaches bins 0.4 … 0.7; every bin is sampled with 1 cm sd.
struct ArmChoice : testing::Test {
    ArmChoice()
    {
        robot.armReachBegin = 0.35;
        robot.armReachEnd = 0.75;
        estimate.sd.fill(0.01);
        estimate.settings.probeAbove = 0.06;
    }
    RobotModel robot;
    TerrainEstimate estimate;
};

TEST_F(ArmChoice, asksForNothingWhenEveryBinIsCertain)
{
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
}

TEST_F(ArmChoice, takesTheMostUncertainBin)
{
    estimate.sd[kBin06] = 0.07;
    estimate.sd[kBin07] = 0.09;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin07);
}

TEST_F(ArmChoice, theLimitItselfIsNotAboveTheLimit)
{
    estimate.sd[kBin06] = 0.06;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
    estimate.sd[kBin06] = std::nextafter(0.06, 1.0);
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

TEST_F(ArmChoice, leavesOutBinsOutOfReach)
{
    estimate.sd[0] = 0.5;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
    estimate.sd[kBin06] = 0.07;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

TEST_F(ArmChoice, leavesOutBinsThatWereMeasured)
{
    estimate.sd[kBin05] = 0.2;
    estimate.origin[kBin05] = Origin::Contact;
    estimate.sd[kBin06] = 0.2;
    estimate.origin[kBin06] = Origin::Arm;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
}

TEST_F(ArmChoice, takesTheNearerOfEquals)
{
    estimate.sd[kBin06] = estimate.sd[kBin07] = 0.08;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

}  // namespace
}  // namespace terratact
