#include "core/wire/telemetry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

Measurement everythingMeasured()
{
    return {.time = 12.5,
            .pitch = 0.21,
            .roll = -0.05,
            .frontLeft = -0.31,
            .frontRight = -0.32,
            .rearLeft = 0.11,
            .rearRight = 0.12,
            .frontLeftCurrent = 1.6,
            .frontRightCurrent = 1.7,
            .rearLeftCurrent = -0.4,
            .rearRightCurrent = -0.5,
            .force = {0.0, 0.5, 2.0, 7.5, 12.0, 19.0},
            .activity = RobotActivity::Pressed,
            .refusal = Refusal::OutOfReach,
            .arm = ArmReading{8, -0.12, 0.03},
            .travelled = 41.237,
            .turned = -0.4};
}

RobotStatus statusOf(const Measurement& m)
{
    return {.epoch = 3, .activity = m.activity, .refusal = m.refusal};
}

struct Wire : testing::Test {
    const RobotModel robot = absolem();

    std::optional<SensorLine> overTheWire(const SensorLine& line)
    {
        SensorLineReader reader;
        std::optional<SensorLine> got;
        for (const CanFrame& frame : framesOf(line, 1))
            got = reader.add(std::get<Unpacked>(unpack(frame)));
        return got;
    }
    std::optional<Measurement> overTheWire(const Measurement& m)
    {
        const auto line = overTheWire(sensorLineOf(m, robot));
        return line ? measurementOf(*line, elementForces(*line, robot), statusOf(m), m.time)
                    : std::nullopt;
    }
};

TEST_F(Wire, carriesEachSideOfAnElement)
{
    Measurement sent = everythingMeasured();
    for (std::size_t e = 0; e < kForceElements; ++e) {
        sent.sides.left[e] = 2.0 + static_cast<double>(e);
        sent.sides.right[e] = 8.0 - static_cast<double>(e);
    }
    const auto received = overTheWire(sent);
    ASSERT_TRUE(received);
    const Measurement& m = *received;
    const SideForces& got = m.sides;
    for (std::size_t e = 0; e < kForceElements; ++e) {
        EXPECT_NEAR(*got.left[e], *sent.sides.left[e], 0.1) << e;
        EXPECT_NEAR(*got.right[e], *sent.sides.right[e], 0.1) << e;
        EXPECT_NEAR(m.force[e], 5.0, 0.1) << e;
    }
    sent.sides.left[2] = 100.0;
    EXPECT_NEAR(*overTheWire(sent)->sides.left[2], robot.forceSaturation, 0.5);
}

TEST_F(Wire, sendsALostElementAsABrokenWire)
{
    Measurement sent = everythingMeasured();
    SideForces sides;
    sides.left.fill(2.0);
    sides.right.fill(8.0);
    sides.left[2].reset();
    setSides(sent, sides);
    const auto got = overTheWire(sent);
    ASSERT_TRUE(got);
    EXPECT_FALSE(got->sides.left[2]);
    EXPECT_NEAR(got->sides.right[2].value(), 8.0, 0.1);
    EXPECT_NEAR(got->force[2], 8.0, 0.1);
}

TEST_F(Wire, carriesRearArraysAndTheDifferential)
{
    RobotModel whole = robot;
    whole.rearElementShare = whole.elementShare;
    whole.differential.locked = false;
    Measurement sent = everythingMeasured();
    sent.differential = -0.25;
    for (std::size_t e = 0; e < kForceElements; ++e) {
        sent.rearSides.left[e] = 1.0 + static_cast<double>(e);
        if (e != 2) sent.rearSides.right[e] = 9.0 - static_cast<double>(e);
    }
    SensorLineReader reader(lineExtent(whole));
    std::optional<SensorLine> line;
    for (const CanFrame& frame : framesOf(sensorLineOf(sent, whole), 1, lineExtent(whole)))
        line = reader.add(std::get<Unpacked>(unpack(frame)));
    ASSERT_TRUE(line);
    const ElementForces forces = elementForces(*line, whole);
    const Measurement got = *measurementOf(*line, forces, statusOf(sent), 0.0);
    EXPECT_NEAR(got.differential.value(), -0.25, 1e-4);
    for (std::size_t e = 0; e < kForceElements; ++e) {
        EXPECT_NEAR(*got.rearSides.left[e], *sent.rearSides.left[e], 0.1) << e;
        ASSERT_EQ(got.rearSides.right[e].has_value(), e != 2);
    }
    EXPECT_EQ(forces.rearRight[2]->state, ElementState::Open) << "a broken wire";
    EXPECT_NEAR(*got.rearSides.right[0], 9.0, 0.1);
    const Measurement plain = *overTheWire(sent);
    EXPECT_EQ(plain.rearSides, SideForces{}) << "Absolem's file has no rear arrays";
    EXPECT_FALSE(plain.differential);
}

TEST_F(Wire, carriesAWholeMeasurement)
{
    const Measurement sent = everythingMeasured();
    const auto got = overTheWire(sent);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->time, sent.time);
    EXPECT_NEAR(got->pitch, sent.pitch, 0.51e-4);
    EXPECT_NEAR(got->roll, sent.roll, 0.51e-4);
    EXPECT_NEAR(got->frontLeft, sent.frontLeft, 0.51e-4);
    EXPECT_NEAR(got->frontRight, sent.frontRight, 0.51e-4);
    EXPECT_NEAR(got->rearLeft, sent.rearLeft, 0.51e-4);
    EXPECT_NEAR(got->rearRight, sent.rearRight, 0.51e-4);
    EXPECT_NEAR(got->frontLeftCurrent, sent.frontLeftCurrent, 0.51e-3);
    EXPECT_NEAR(got->frontRightCurrent, sent.frontRightCurrent, 0.51e-3);
    EXPECT_NEAR(got->rearLeftCurrent, sent.rearLeftCurrent, 0.51e-3);
    EXPECT_NEAR(got->rearRightCurrent, sent.rearRightCurrent, 0.51e-3);
    EXPECT_EQ(got->activity, sent.activity);
    EXPECT_EQ(got->refusal, sent.refusal);
    EXPECT_EQ(got->arm->bin, 8);
    EXPECT_NEAR(got->arm->height, -0.12, 1e-9);
    EXPECT_NEAR(got->arm->sd, 0.03, 1e-9);
    EXPECT_NEAR(got->travelled.value(), 41.237, 0.51e-3);
    EXPECT_NEAR(got->turned.value(), -0.4, 1.01e-4);
    for (std::size_t e = 0; e < got->force.size(); ++e)
        EXPECT_NEAR(got->force[e], sent.force[e], 0.005 + 0.003 * sent.force[e]) << e;
}

TEST_F(Wire, skipsElementsThatTheRobotLacks)
{
    RobotModel one = absolem();
    one.forceArrays.pop_back();  // the right one
    const SensorLine line = *overTheWire(sensorLineOf(everythingMeasured(), one));
    EXPECT_EQ((*line.voltages[2])[0], 0.0) << "nothing is wired there";
    const ElementForces forces = elementForces(line, one);
    EXPECT_TRUE(forces.left[4]);
    EXPECT_FALSE(forces.right[4]) << "no broken wire of an element that does not exist";
    const auto got = measurementOf(line, forces, statusOf(everythingMeasured()), 0.0);
    ASSERT_TRUE(got);
    EXPECT_NEAR(got->force[4], 12.0, 0.05) << "of the left array alone";
}

TEST_F(Wire, losesLittleOfAForceToItsRawVoltage)
{
    Measurement m = everythingMeasured();
    double worst = 0.0;
    for (double force = 0.0; force <= 19.7; force += 0.01) {
        m.force.fill(force);
        const auto got = overTheWire(m);
        ASSERT_TRUE(got);
        for (const double f : got->force) worst = std::max(worst, std::abs(f - force));
    }
    RecordProperty("worst_mN", static_cast<int>(std::lround(1e3 * worst)));
    EXPECT_LT(worst, 0.05) << "a sixth of what a force's noise is";
}

TEST_F(Wire, sendsAWayBeyondItsSignalAsNotMeasured)
{
    Measurement m = everythingMeasured();
    m.turned = 7.0;
    EXPECT_NEAR(overTheWire(m)->turned.value(), 7.0 - 2.0 * std::numbers::pi, 1.01e-4);
    for (const double way : {8388.7, -8388.7}) {
        m.travelled = way;
        EXPECT_FALSE(overTheWire(m)->travelled) << way;
    }
    m.travelled.reset();
    EXPECT_FALSE(overTheWire(m)->travelled);
    EXPECT_FALSE(overTheWire(m)->turned);
}

TEST_F(Wire, sendsAWayWithoutAHeadingAsNotMeasured)
{
    Measurement m = everythingMeasured();
    m.turned.reset();
    EXPECT_FALSE(overTheWire(m)->travelled) << "a heading of 0 would say that it never turns";
    EXPECT_FALSE(overTheWire(m)->turned);
}

TEST_F(Wire, clampsValuesBeyondTheirSignal)
{
    Measurement m = everythingMeasured();
    m.frontLeft = 3.0 * std::numbers::pi;
    m.rearRight = -1.0 - 2.0 * std::numbers::pi;
    m.frontLeftCurrent = 99.0;
    m.rearLeftCurrent = -99.0;
    m.force.fill(1000.0);
    m.arm->sd = 0.0;
    m.arm->height = 17.0;
    const auto got = overTheWire(m);
    ASSERT_TRUE(got);
    EXPECT_NEAR(std::abs(got->frontLeft), std::numbers::pi, 1e-4);
    EXPECT_NEAR(got->rearRight, -1.0, 1e-4);
    EXPECT_NEAR(got->frontLeftCurrent, 20.0, 1e-9);
    EXPECT_NEAR(got->rearLeftCurrent, -20.0, 1e-9);
    EXPECT_NEAR(got->force[0], 19.7, 0.05);
    EXPECT_GT(got->arm->sd, 0.0);
    EXPECT_NEAR(got->arm->height, 2.0, 1e-9);
}

TEST_F(Wire, makesNoMeasurementWithoutAPose)
{
    const SensorLine whole = sensorLineOf(everythingMeasured(), robot);
    const auto has = [&](const SensorLine& line) {
        return measurementOf(line, elementForces(line, robot), statusOf(everythingMeasured()), 0.0)
            .has_value();
    };
    ASSERT_TRUE(has(whole));
    SensorLine line = whole;
    line.arm.reset();
    EXPECT_TRUE(has(line)) << "no probe is no loss";
    (line = whole).attitude.reset();
    EXPECT_FALSE(has(line));
    (line = whole).frontAngles.reset();
    EXPECT_FALSE(has(line));
    (line = whole).rearAngles.reset();
    EXPECT_FALSE(has(line));
}

TEST_F(Wire, namesMissingCurrentsAndForces)
{
    SensorLine line = sensorLineOf(everythingMeasured(), robot);
    line.rearCurrents = {};
    line.voltages[1].reset();  // elements 4 to 6 of both arrays
    line.voltages[3].reset();
    const auto got = measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0);
    ASSERT_TRUE(got);
    const Proprioception s = proprioception(*got);
    EXPECT_TRUE(s.frontCurrent && s.force[2]);
    EXPECT_FALSE(s.rearCurrent || s.force[3] || s.force[4] || s.force[5]);
    EXPECT_EQ(got->missing, missingFeatures(s));
    EXPECT_EQ(overTheWire(*got)->missing, got->missing) << "as a robot sends it on";
}

TEST_F(Wire, carriesTheCurrentOfOneMotor)
{
    Measurement sent = everythingMeasured();
    setCurrents(sent, {std::nullopt, 1.7, -0.4, std::nullopt});
    const auto got = overTheWire(sent);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->missingMotors, sent.missingMotors);
    EXPECT_EQ(got->missing, sent.missing);
    EXPECT_NEAR(proprioception(*got).frontCurrent.value(), 1.7, 0.51e-3);
    EXPECT_NEAR(proprioception(*got).rearCurrent.value(), -0.4, 0.51e-3);
}

TEST_F(Wire, usesTheOtherSideOfABrokenElement)
{
    SensorLine line = sensorLineOf(everythingMeasured(), robot);
    (*line.voltages[0])[1] = 0.0;  // left element 2: wire broken
    (*line.voltages[3])[2] = 5.0;  // right element 6: short
    const ElementForces elements = elementForces(line, robot);
    EXPECT_EQ(elements.left[1]->state, ElementState::Open);
    EXPECT_EQ(elements.right[5]->state, ElementState::Short);
    EXPECT_EQ(elements.left[5]->state, ElementState::Sound);
    const auto got = measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0);
    ASSERT_TRUE(got);
    EXPECT_NEAR(got->force[1], 0.5, 1e-6);
    EXPECT_NEAR(got->force[5], 19.0, 1e-6);
    (*line.voltages[2])[1] = 0.0;  // and right element 2
    EXPECT_FALSE(
        proprioception(*measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0))
            .force[1]);
}

TEST_F(Wire, averagesLeftAndRightAndDoesWithoutOneArray)
{
    Measurement m = everythingMeasured();
    m.force.fill(4.0);
    SensorLine line = sensorLineOf(m, robot);
    m.force.fill(2.0);
    const SensorLine weaker = sensorLineOf(m, robot);
    line.voltages[2] = weaker.voltages[2];
    line.voltages[3] = weaker.voltages[3];
    EXPECT_NEAR(measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0)->force[4], 3.0,
                1e-6);
    line.voltages[0].reset();
    line.voltages[1].reset();
    EXPECT_NEAR(measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0)->force[0], 2.0,
                1e-6);
    EXPECT_FALSE(elementForces(line, robot).left[0]);
    line.voltages[3].reset();
    EXPECT_FALSE(
        proprioception(*measurementOf(line, elementForces(line, robot), RobotStatus{}, 0.0))
            .force[5]);
}

}  // namespace
}  // namespace terratact
