#include "core/robot/force_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/robot/force_drift.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Resistance of an element that the world has, other than the file believes: R = 9000 / F^0.9.
double resistanceAt(double force)
{
    return 9000.0 / std::pow(force, 0.9);
}

double biasOf(int element, Side side)
{
    return 0.25 + 0.02 * element + (side == Side::Right ? 0.05 : 0.0);
}

struct Recording : testing::Test {
    ForceCalibration present = absolem().forceCalibration;
    std::vector<ForceReading> readings;

    void record(double applied)
    {
        for (const Side side : {Side::Left, Side::Right})
            for (int e = 0; e < kForceElements; ++e) {
                const double r = resistanceAt(applied + biasOf(e, side));
                readings.push_back({side, e, applied,
                                    present.supply * present.reference / (present.reference + r)});
            }
    }
};

TEST_F(Recording, givesTheAppliedForcesBack)
{
    for (const double applied : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) record(applied);
    const auto fitted = calibrate(readings, present, leftAndRightArrays());
    ASSERT_TRUE(fitted) << fitted.error().text;
    EXPECT_EQ(fitted->calibration.curve.size(), 7U);
    EXPECT_LT(fitted->medianError, 0.05);
    EXPECT_LT(fitted->worstError, 0.15) << "the elements' biases differ by 0.15 N";
    double before = 0.0;
    for (const ForceReading& r : readings) {
        const ElementForce felt = elementForce(r.voltage, r.side, r.element, present, 1000.0);
        before = std::max(before, std::abs(felt.force - r.applied));
    }
    EXPECT_GT(before, 10.0 * fitted->worstError) << "than the file's own curve";
}

TEST_F(Recording, unloadedReadingsFitOnlyTheBias)
{
    record(0.0);
    const auto fitted = calibrate(readings, present, leftAndRightArrays());
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->calibration.curve, present.curve);
    EXPECT_NEAR(fitted->worstError, 0.0, 1e-9);
    EXPECT_NEAR(fitted->calibration.biasRight[5],
                curveForce(resistanceAt(biasOf(5, Side::Right)), present), 1e-9);
    EXPECT_LT(fitted->calibration.biasLeft[0], fitted->calibration.biasLeft[5]);
}

TEST_F(Recording, takesTheMedianOfTheUnloadedReadings)
{
    for (int i = 0; i < 3; ++i) record(0.0);
    const auto clean = calibrate(readings, present, leftAndRightArrays());
    readings[0].voltage = 4.9;  // somebody stood on it
    const auto disturbed = calibrate(readings, present, leftAndRightArrays());
    ASSERT_TRUE(clean && disturbed);
    EXPECT_NEAR(disturbed->calibration.biasLeft[0], clean->calibration.biasLeft[0], 1e-12);
}

TEST_F(Recording, needsNoReadingsOfElementsThatTheRobotLacks)
{
    for (const double applied : {0.0, 1.0, 4.0}) record(applied);
    std::vector<ForceArrayLayout> arrays = leftAndRightArrays();
    arrays.pop_back();
    const auto strange = calibrate(readings, present, arrays);
    ASSERT_FALSE(strange);
    EXPECT_EQ(strange.error().text, "right element 1 belongs to no force array of the robot");
    const auto both = calibrate(readings, present, leftAndRightArrays());
    ASSERT_TRUE(both);
    std::erase_if(readings, [](const ForceReading& r) { return r.side == Side::Right; });
    EXPECT_FALSE(calibrate(readings, present, leftAndRightArrays())) << "half of them are missing";
    const auto fitted = calibrate(readings, present, arrays);
    ASSERT_TRUE(fitted) << fitted.error().text;
    EXPECT_LT(fitted->worstError, 0.15);
    EXPECT_EQ(fitted->calibration.biasRight, present.biasRight) << "stays";
    EXPECT_LT(fitted->calibration.curve.front().force, both->calibration.curve.front().force - 0.01)
        << "the left elements' bias is smaller";
}

TEST_F(Recording, isRefusedWithTheReason)
{
    const auto why = [&] {
        const auto fitted = calibrate(readings, present, leftAndRightArrays());
        return fitted ? std::string("accepted") : fitted.error().text;
    };
    EXPECT_EQ(why(), "left element 1 has no unloaded reading");
    record(0.0);
    readings[11].applied = 1.0;
    EXPECT_EQ(why(), "right element 6 has no unloaded reading");
    readings.clear();
    record(0.0);
    record(2.0);
    readings[14].voltage = 0.0;
    EXPECT_EQ(why(), "left element 3 at 0 V: wire broken");
    readings[14].voltage = 4.99;
    EXPECT_EQ(why(), "left element 3 at 4.99 V: short circuit");
    readings.clear();
    record(0.0);
    record(2.0);
    for (std::size_t i = 12; i < 24; ++i) readings[i].applied = 0.5, readings[i].voltage = 1.0;
    EXPECT_EQ(why(), "the resistance does not fall up to 0.5 N");
    readings[3].element = 6;
    EXPECT_THROW(static_cast<void>(why()), std::invalid_argument);
    readings[3].element = 3;
    readings[3].applied = -1.0;
    EXPECT_THROW(static_cast<void>(why()), std::invalid_argument);
    readings[3].applied = std::nan("");
    EXPECT_THROW(static_cast<void>(why()), std::invalid_argument);
    readings[3].applied = 0.0;
    readings[3].voltage = std::nan("");
    EXPECT_THROW(static_cast<void>(why()), std::invalid_argument);
}

ForceDrift::Forces everywhere(std::optional<double> force)
{
    ForceDrift::Forces forces;
    forces.fill(force);
    return forces;
}

void addFor(ForceDrift& drift, double from, double seconds, std::optional<double> force)
{
    for (int i = 0; i * 0.05 < seconds; ++i) drift.add(from + i * 0.05, everywhere(force));
}

TEST(ForceDriftTest, isTheMedianOfUnloadedReadings)
{
    ForceDrift drift;
    addFor(drift, 0.0, 1.8, 0.4);
    EXPECT_FALSE(drift.drift(0)) << "too little was read";
    addFor(drift, 1.8, 2.2, 0.4);
    addFor(drift, 4.0, 1.0, 1.9);  // a pebble
    ASSERT_TRUE(drift.drift(5));
    EXPECT_DOUBLE_EQ(*drift.drift(5), 0.4);
    addFor(drift, 5.0, 20.0, 0.4);
    addFor(drift, 25.0, 6.0, -0.5);
    EXPECT_DOUBLE_EQ(*drift.drift(5), -0.5) << "what is older than 10 s no longer counts";
    EXPECT_THROW(static_cast<void>(drift.drift(6)), std::out_of_range);
}

TEST(ForceDriftTest, skipsElementsWithoutAReading)
{
    ForceDrift drift;
    ForceDrift::Forces forces = everywhere(0.1);
    forces[2] = std::nullopt;
    forces[3] = std::nan("");
    for (int i = 0; i < 50; ++i) drift.add(0.1 * i, forces);
    EXPECT_TRUE(drift.drift(1));
    EXPECT_FALSE(drift.drift(2));
    EXPECT_FALSE(drift.drift(3));
    EXPECT_THROW(drift.add(std::nan(""), forces), std::invalid_argument);
}

TEST(ForceDriftTest, restartsWhenItsClockJumpsBack)
{
    ForceDrift drift;
    addFor(drift, 100.0, 5.0, 0.4);
    drift.add(3.0, everywhere(0.0));
    EXPECT_FALSE(drift.drift(0));
}

TEST(ForceDriftTest, unloadedIsRaisedBelowTheLimitAndNotPressing)
{
    Measurement m;
    m.frontLeft = m.frontRight = 0.7;
    m.force.fill(0.4);
    for (const RobotActivity a : {RobotActivity::Halted, RobotActivity::Driving}) {
        m.activity = a;
        EXPECT_TRUE(isUnloaded(m, 2.0));
    }
    for (const RobotActivity a : {RobotActivity::Pressing, RobotActivity::Pressed,
                                  RobotActivity::Probing, RobotActivity::Stopped}) {
        m.activity = a;
        EXPECT_FALSE(isUnloaded(m, 2.0));
    }
    m.activity = RobotActivity::Halted;
    m.force[4] = 2.0;
    EXPECT_FALSE(isUnloaded(m, 2.0));
    m.force[4] = 0.4;
    m.frontRight = 0.1;
    EXPECT_FALSE(isUnloaded(m, 2.0)) << "one flipper lies on the ground";
}

TEST(ForceDriftTest, aBiasThatFellReadsNegative)
{
    const ForceCalibration c = absolem().forceCalibration;
    const double open = c.openBelow / 2.0;
    const auto voltage = [&](double force) {
        const double r = 6000.0 / force;  // the curve between 0.2 and 1 N
        return c.supply * c.reference / (c.reference + r);
    };
    EXPECT_NEAR(elementForce(voltage(0.2), Side::Left, 0, c, 20.0).beyondBias, -0.1, 1e-9);
    EXPECT_EQ(elementForce(voltage(0.2), Side::Left, 0, c, 20.0).force, 0.0);
    EXPECT_NEAR(elementForce(voltage(0.7), Side::Right, 0, c, 20.0).beyondBias, 0.4, 1e-9);
    EXPECT_EQ(elementForce(open, Side::Left, 0, c, 20.0).beyondBias, 0.0);
    const ElementForce saturated = elementForce(0.99 * c.shortAbove, Side::Left, 0, c, 20.0);
    EXPECT_EQ(saturated.state, ElementState::Saturated);
    EXPECT_EQ(saturated.beyondBias, 0.0);
}

}  // namespace
}  // namespace terratact
