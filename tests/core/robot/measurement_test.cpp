#include "core/robot/measurement.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace terratact {
namespace {

TEST(Measurement, becomesTheAverageOfLeftAndRight)
{
    Measurement m;
    m.pitch = 0.1;
    m.frontLeft = 0.2, m.frontRight = 0.4, m.rearLeft = -0.2;
    m.frontLeftCurrent = 1.0, m.frontRightCurrent = 2.0, m.rearLeftCurrent = -1.0;
    m.force = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    const Proprioception s = proprioception(m);
    EXPECT_EQ(s.pitch, 0.1);
    EXPECT_DOUBLE_EQ(s.front, 0.3);
    EXPECT_DOUBLE_EQ(s.rear, -0.1);
    EXPECT_EQ(s.frontCurrent, 1.5);
    EXPECT_EQ(s.rearCurrent, -0.5);
    for (std::size_t i = 0; i < kForceElements; ++i)
        EXPECT_EQ(s.force[i], 1.0 + static_cast<double>(i));
}

TEST(Measurement, aForceIsTheMeanOfItsKnownSides)
{
    Measurement m;
    m.force.fill(9.0);
    SideForces sides;
    sides.left = {1.0, 2.0, std::nullopt, std::nullopt, 0.0, 6.0};
    sides.right = {3.0, std::nullopt, 4.0, std::nullopt, 0.0, 7.0};
    setSides(m, sides);
    EXPECT_EQ(m.sides, sides);
    EXPECT_EQ(m.force, (std::array{2.0, 2.0, 4.0, 0.0, 0.0, 6.5}));
    for (std::size_t e = 0; e < kForceElements; ++e)
        EXPECT_EQ(m.missing[kFirstForceFeature + e], e == 3) << e;
    EXPECT_FALSE(proprioception(m).force[3]);
}

TEST(Measurement, aCurrentIsTheMeanOfItsKnownMotors)
{
    Measurement m;
    setCurrents(m, {std::nullopt, 2.0, 1.0, 4.0});
    EXPECT_EQ(motorCurrents(m), (MotorCurrents{std::nullopt, 2.0, 1.0, 4.0}));
    EXPECT_EQ(proprioception(m).frontCurrent, 2.0);
    EXPECT_EQ(proprioception(m).rearCurrent, 2.5);
    EXPECT_TRUE(m.missing.none());
    EXPECT_EQ(m.missingMotors.to_string(), "0001");
    setCurrents(m, {std::nullopt, std::nullopt, 1.0, std::nullopt});
    EXPECT_FALSE(proprioception(m).frontCurrent);
    EXPECT_EQ(proprioception(m).rearCurrent, 1.0);
    EXPECT_EQ(m.frontRightCurrent, 0.0);
    EXPECT_TRUE(m.missing[kFrontCurrentFeature]);
    EXPECT_FALSE(m.missing[kRearCurrentFeature]);
    EXPECT_EQ(m.missingMotors.to_string(), "1000");
}

TEST(Measurement, everyActivityAndRefusalHasADistinctText)
{
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(RobotActivity::Stopped); ++i)
        words.insert(describe(static_cast<RobotActivity>(i)).english);
    for (int i = 0; i <= static_cast<int>(Refusal::OutOfLimits); ++i)
        words.insert(describe(static_cast<Refusal>(i)).english);
    EXPECT_EQ(words.size(), 15U);
    EXPECT_THROW(static_cast<void>(describe(static_cast<Refusal>(99)).english),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
