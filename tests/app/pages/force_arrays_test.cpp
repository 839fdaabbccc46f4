#include "app/pages/force_arrays.h"

#include <gtest/gtest.h>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

struct ForceArraysTest : testing::Test {
    RobotModel robot = absolem();
    Measurement measurement;
    ElementForces felt{};

    ForceArraysTest()
    {
        felt.carried = true;
        felt.left[0] = ElementForce{4.0, ElementState::Sound, 4.0, 2.1};
        felt.left[1] = ElementForce{0.0, ElementState::Sound, -0.4, 0.3};
        felt.left[2] = ElementForce{19.0, ElementState::Saturated, 0.0, 4.6};
        felt.left[3] = ElementForce{0.0, ElementState::Open, 0.0, 0.0};
    }
};

TEST_F(ForceArraysTest, showsForceAndVoltageOfTheSameLine)
{
    const std::vector<ForceArray> arrays = ForceArrays(robot).of(measurement, felt, 2.0);
    ASSERT_EQ(arrays.size(), robot.forceArrays.size());
    const auto& left = arrays[0].elements;
    EXPECT_EQ(left[0].newtons, 4.0);
    EXPECT_EQ(left[0].volts, 2.1);
    EXPECT_EQ(left[2].newtons, 19.0);
    EXPECT_TRUE(left[2].saturated);
    EXPECT_FALSE(left[0].saturated);
}

TEST_F(ForceArraysTest, aBrokenWireHasAVoltageAndNoForce)
{
    const auto left = ForceArrays(robot).of(measurement, felt, 2.0)[0].elements;
    EXPECT_FALSE(left[3].newtons);
    EXPECT_EQ(left[3].volts, 0.0);
    EXPECT_FALSE(left[4].volts) << "not measured";
    EXPECT_TRUE(left[4].exists);
}

TEST_F(ForceArraysTest, omitsElementsThatTheRobotLacks)
{
    robot.forceArrays = {{.name = "tip", .side = Side::Left, .has = {}}};
    robot.forceArrays[0].has[2] = true;
    const std::vector<ForceArray> arrays = ForceArrays(robot).of(measurement, felt, 2.0);
    ASSERT_EQ(arrays.size(), 1U);
    EXPECT_EQ(arrays[0].name, "tip");
    EXPECT_FALSE(arrays[0].elements[0].exists);
    EXPECT_FALSE(arrays[0].elements[0].newtons);
    EXPECT_EQ(arrays[0].elements[2].newtons, 19.0);
}

TEST_F(ForceArraysTest, withoutVoltagesShowsMeasuredForces)
{
    measurement.force = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    measurement.missing[kFirstForceFeature + 1] = true;
    const std::vector<ForceArray> arrays = ForceArrays(robot).of(measurement, {}, 2.0);
    ASSERT_EQ(arrays.size(), 1U);
    EXPECT_EQ(arrays[0].elements[0].newtons, 1.0);
    EXPECT_FALSE(arrays[0].elements[1].newtons);
    EXPECT_FALSE(arrays[0].elements[0].volts);
}

TEST_F(ForceArraysTest, tracksSignedDriftOnlyWithoutLoad)
{
    ForceArrays arrays(robot);
    measurement.activity = RobotActivity::Halted;
    measurement.frontLeft = measurement.frontRight = 0.5;
    for (int i = 0; i < 30; ++i) {
        measurement.time = 0.2 * i;
        arrays.of(measurement, felt, 2.0);
    }
    EXPECT_EQ(arrays.of(measurement, felt, 2.0)[0].elements[1].drift, -0.4);
    EXPECT_FALSE(arrays.of(measurement, felt, 2.0)[0].elements[3].drift) << "broken";

    ForceArrays pressed(robot);
    measurement.activity = RobotActivity::Pressed;
    for (int i = 0; i < 30; ++i) {
        measurement.time = 0.2 * i;
        pressed.of(measurement, felt, 2.0);
    }
    EXPECT_FALSE(pressed.of(measurement, felt, 2.0)[0].elements[1].drift);
}

}  // namespace
}  // namespace terratact
