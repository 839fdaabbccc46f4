#include "core/robot/force_sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

struct ForceSensor : testing::Test {
    ForceCalibration calibration = absolem().forceCalibration;
    double saturation = 20.0;

    double voltageAt(double resistance) const
    {
        return calibration.supply * calibration.reference / (calibration.reference + resistance);
    }
    ElementForce read(double voltage, int element = 0, Side side = Side::Left) const
    {
        return elementForce(voltage, side, element, calibration, saturation);
    }
};

TEST_F(ForceSensor, findsTheResistanceFromTheDivider)
{
    EXPECT_NEAR(elementResistance(2.5, calibration), 10e3, 1e-6);
    EXPECT_NEAR(elementResistance(1.25, calibration), 30e3, 1e-6);
    for (const double voltage : {0.0, -1.0, 5.0, 6.0, std::nan("")})
        EXPECT_THROW(static_cast<void>(elementResistance(voltage, calibration)),
                     std::invalid_argument);
}

TEST_F(ForceSensor, readsThePointsOfItsCurveExactly)
{
    for (const ForcePoint& point : calibration.curve)
        EXPECT_NEAR(curveForce(point.resistance, calibration), point.force, 1e-9 * point.force);
}

TEST_F(ForceSensor, interpolatesOnStraightLinesOfTheLogarithms)
{
    // Half-way between 1 N at 6 kΩ and 10 N at 1 kΩ.
    EXPECT_NEAR(curveForce(std::sqrt(6e3 * 1e3), calibration), std::sqrt(10.0), 1e-9);
    // Slope −1 between 0.2 and 1 N: force times resistance is constant.
    EXPECT_NEAR(curveForce(12e3, calibration), 0.5, 1e-9);
    // The end pieces continue beyond the ends.
    EXPECT_NEAR(curveForce(60e3, calibration), 0.1, 1e-9);
    EXPECT_NEAR(curveForce(62.5, calibration), 1000.0, 1e-6);
}

TEST_F(ForceSensor, neverJumpsAndAlwaysRisesWithTheVoltage)
{
    double before = -1.0;
    for (double v = calibration.openBelow; v <= calibration.shortAbove; v += 6.25e-4) {
        const double force = read(v).force;
        ASSERT_GE(force, before) << v;
        ASSERT_LT(force - before, 1.5) << v;
        before = force;
    }
    EXPECT_EQ(before, saturation - calibration.biasLeft[0]);
}

TEST_F(ForceSensor, subtractsItsOwnBias)
{
    calibration.biasLeft = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    calibration.biasRight = {0.7, 0.8, 0.9, 1.0, 1.1, 1.2};
    const double volts = voltageAt(1e3);  // 10 N
    for (int e = 0; e < kForceElements; ++e) {
        EXPECT_NEAR(read(volts, e).force, 9.9 - 0.1 * e, 1e-9);
        EXPECT_NEAR(read(volts, e, Side::Right).force, 9.3 - 0.1 * e, 1e-9);
        EXPECT_EQ(read(volts, e).state, ElementState::Sound);
    }
    EXPECT_EQ(read(voltageAt(30e3), 5).force, 0.0) << "less than the bias is nothing";
}

TEST_F(ForceSensor, reportsSaturatedOpenAndShort)
{
    EXPECT_EQ(read(voltageAt(250.0)),
              (ElementForce{19.7, ElementState::Saturated, 0.0, voltageAt(250.0)}));
    EXPECT_EQ(read(0.0), (ElementForce{0.0, ElementState::Open, 0.0, 0.0}));
    EXPECT_EQ(read(-0.1).state, ElementState::Open);
    EXPECT_EQ(read(calibration.openBelow - 1e-6).state, ElementState::Open);
    EXPECT_EQ(read(calibration.openBelow).state, ElementState::Sound);
    EXPECT_EQ(read(calibration.shortAbove).state, ElementState::Saturated);
    const double shorted = calibration.shortAbove + 1e-6;
    EXPECT_EQ(read(shorted), (ElementForce{0.0, ElementState::Short, 0.0, shorted}));
    EXPECT_EQ(read(5.0).state, ElementState::Short);
    EXPECT_EQ(read(1e300).state, ElementState::Short);
}

TEST_F(ForceSensor, staysFiniteWhereItsThresholdsAreAtTheRails)
{
    calibration.openBelow = 0.0;
    calibration.shortAbove = calibration.supply;
    EXPECT_EQ(read(0.0).state, ElementState::Open);
    EXPECT_EQ(read(calibration.supply).state, ElementState::Short);
    for (const double v : {1e-300, 1e-9, std::nextafter(5.0, 0.0)}) {
        EXPECT_TRUE(std::isfinite(read(v).force)) << v;
        EXPECT_GE(read(v).force, 0.0) << v;
    }
}

TEST_F(ForceSensor, refusesInvalidArguments)
{
    EXPECT_THROW(static_cast<void>(read(std::nan(""))), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(read(INFINITY)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(read(1.0, -1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(read(1.0, 6)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(curveForce(0.0, calibration)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(curveForce(INFINITY, calibration)), std::invalid_argument);
    const auto refuses = [](std::vector<ForcePoint> curve) {
        ForceCalibration c;
        c.curve = std::move(curve);
        EXPECT_THROW(static_cast<void>(curveForce(1e3, c)), std::invalid_argument);
    };
    refuses({});
    refuses({{1.0, 1e3}});
    refuses({{1.0, 1e3}, {1.0, 1e2}});
    refuses({{1.0, 1e3}, {2.0, 1e3}});
    refuses({{0.0, 1e3}, {2.0, 1e2}});
    refuses({{1.0, 1e3}, {2.0, 0.0}});
    refuses({{1.0, 1e3}, {std::nan(""), 1e2}});
}

TEST(ElementState, hasWords)
{
    for (int i = 0; i < 4; ++i) EXPECT_STRNE(describe(static_cast<ElementState>(i)).english, "");
    EXPECT_THROW(static_cast<void>(describe(static_cast<ElementState>(4)).english),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
