#include "core/sim/sensor_fault.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/robot/robot_model.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

Measurement line(double time, double pitch)
{
    Measurement m;
    m.time = time;
    m.pitch = pitch;
    m.frontLeft = 0.3;
    m.frontRight = 0.4;
    m.rearLeft = -0.1;
    m.rearRight = -0.2;
    m.force = {1, 2, 3, 4, 5, 6};
    m.travelled = 2.0;
    return m;
}

FaultySensors with(std::string_view text)
{
    return {*sensorFaultFrom(text), absolem(), 1};
}

TEST(SensorFault, ReadsKindSensorsAndAmount)
{
    const auto fault = sensorFaultFrom("offset:front:0.17");
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, FaultKind::Offset);
    EXPECT_EQ(fault->sensors, (std::vector{Sensor::FrontLeft, Sensor::FrontRight}));
    EXPECT_DOUBLE_EQ(fault->amount, 0.17);
    EXPECT_DOUBLE_EQ(sensorFaultFrom("late:all")->amount, 0.5);
    for (const char* wrong : {"", "stuck", "stuck:", "stuck:nose", "stick:pitch", "offset:pitch:",
                              "offset:pitch:x", "offset:pitch:nan", "late:all:-1", "late:all:11"})
        EXPECT_FALSE(sensorFaultFrom(wrong)) << wrong;
}

/// Returns the words of the syntax between two words.
std::vector<std::string> wordsBetween(const std::string& before, const std::string& after)
{
    const std::string syntax = sensorFaultSyntax();
    const std::size_t begin = syntax.find(before) + before.size();
    std::istringstream words(syntax.substr(begin, syntax.find(after, begin) - begin));
    return {std::istream_iterator<std::string>(words), {}};
}

/// Returns line k of a drive: it presses for five lines in ten, and every reading differs from line to line.
Measurement lineOfPresses(int k)
{
    Measurement m;
    m.activity = k % 10 < 5 ? RobotActivity::Pressed : RobotActivity::Driving;
    for (std::size_t e = 0; e < kForceElements; ++e) m.sides.left[e] = m.sides.right[e] = 1.0;
    m.travelled = 0.0;
    for (std::size_t i = 0; i < kSensors; ++i)
        setReading(m, sensorAt(i), 1.0 + 0.1 * static_cast<double>(i) + 0.01 * k);
    m.time = 0.1 * k;
    return m;
}

/// Returns true if the fault changes a reading of the drive.
bool acts(const std::string& fault)
{
    FaultySensors faulty = with(fault);
    bool isChanged = false;
    for (int k = 0; k < 40; ++k) {
        const SensorReadings wrong = readingsOf(faulty.apply(lineOfPresses(k)));
        isChanged = isChanged || wrong != readingsOf(lineOfPresses(k));
    }
    return isChanged;
}

/// Returns true for sensors without which there is no line of telemetry.
bool isOfThePose(const std::string& sensors)
{
    const auto read = sensorFaultFrom("zero:" + sensors);
    return read && std::all_of(read->sensors.begin(), read->sensors.end(), [](Sensor sensor) {
               return sensor <= Sensor::RearRight;
           });
}

TEST(SensorFault, EveryKindActsAtEverySensor)
{
    const std::vector<std::string> kinds = wordsBetween("KIND one of", ", SENSORS");
    const std::vector<std::string> sensors = wordsBetween("SENSORS one of", ";");
    EXPECT_EQ(kinds.size(), 14U);
    EXPECT_EQ(kinds.back(), "lost");
    EXPECT_EQ(sensors.size(), 40U);
    for (const std::string& kind : kinds)
        for (const std::string& sensor : sensors) {
            const std::string fault = kind + ':' + sensor;
            if (kind == "lost" && isOfThePose(sensor)) {
                EXPECT_FALSE(sensorFaultFrom(fault)) << fault;
                continue;
            }
            ASSERT_TRUE(sensorFaultFrom(fault)) << fault;
            const SensorKind what = kindOf(sensorFaultFrom(fault)->sensors.front());
            const bool isAlone = what == SensorKind::Attitude || what == SensorKind::Way;
            const bool hasNoOther =
                sensor != "all"
                && ((kind == "swapped" && isAlone)
                    || (kind == "swapped-axles" && (isAlone || what == SensorKind::Force)));
            EXPECT_EQ(acts(fault), !hasNoOther) << fault;
        }
}

TEST(SensorFault, OfOneSideHalvesTheMean)
{
    EXPECT_EQ(sensorFaultFrom("stuck:left-force-1")->sensors, std::vector{Sensor::LeftForce1});
    EXPECT_FALSE(sensorFaultFrom("stuck:left-pitch"));
    EXPECT_DOUBLE_EQ(with("offset:right-force-2:3").apply(line(0.0, 0.1)).force[1], 3.5);
    EXPECT_DOUBLE_EQ(with("zero:left-forces").apply(line(0.0, 0.1)).force[5], 3.0);
    const Measurement swapped = with("swapped:left-forces").apply(line(0.0, 0.1));
    EXPECT_DOUBLE_EQ(swapped.force[0], 3.5);
    EXPECT_DOUBLE_EQ(swapped.force[5], 3.5);
}

TEST(SensorFault, OfOneSideLeavesTheOther)
{
    Measurement truth = line(0.0, 0.1);
    for (std::size_t e = 0; e < kForceElements; ++e) {
        truth.sides.left[e] = truth.force[e] + 0.5;
        truth.sides.right[e] = truth.force[e] - 0.5;
    }
    const Measurement one = with("offset:right-force-2:3").apply(truth);
    EXPECT_DOUBLE_EQ(*one.sides.right[1], 4.5);
    EXPECT_EQ(one.sides.left, truth.sides.left);
    EXPECT_DOUBLE_EQ(one.force[1], 3.5);
    const Measurement both = with("zero:force-6").apply(truth);
    EXPECT_EQ(*both.sides.left[5], 0.0);
    EXPECT_EQ(both.force[5], 0.0);
    const Measurement swapped = with("swapped:left-forces").apply(truth);
    EXPECT_DOUBLE_EQ(*swapped.sides.left[0], 6.5);
    EXPECT_EQ(swapped.sides.right, truth.sides.right);
    const Measurement pushed = with("scatter:force-3:1").apply(truth);
    EXPECT_DOUBLE_EQ(*pushed.sides.left[2] - *pushed.sides.right[2], 1.0);
}

TEST(SensorFault, SticksAtTheFirstLine)
{
    FaultySensors faulty = with("stuck:pitch");
    EXPECT_EQ(faulty.apply(line(0.0, 0.1)).pitch, 0.1);
    const Measurement second = faulty.apply(line(1.0, 0.2));
    EXPECT_EQ(second.pitch, 0.1);
    EXPECT_EQ(second.frontLeft, 0.3);
}

TEST(SensorFault, ShowsTheLastSceneUntilTheNextPress)
{
    FaultySensors faulty = with("stuck-at-scene:pitch");
    const auto add = [&](double time, double pitch, RobotActivity activity) {
        Measurement m = line(time, pitch);
        m.activity = activity;
        return faulty.apply(m).pitch;
    };
    EXPECT_EQ(add(0.0, 0.1, RobotActivity::Pressed), 0.1);
    EXPECT_EQ(add(0.1, 0.11, RobotActivity::Pressed), 0.11);
    EXPECT_EQ(add(1.0, 0.2, RobotActivity::Driving), 0.1);
    EXPECT_EQ(add(2.0, 0.3, RobotActivity::Pressed), 0.1);
    EXPECT_EQ(add(3.0, 0.4, RobotActivity::Driving), 0.3);
}

TEST(SensorFault, DriftsByItsAmountInAMinute)
{
    FaultySensors faulty = with("drift:pitch:0.1");
    faulty.apply(line(0.0, 0.0));
    EXPECT_NEAR(faulty.apply(line(30.0, 0.0)).pitch, 0.05, 1e-12);
}

TEST(SensorFault, IsLateByItsAmount)
{
    FaultySensors faulty = with("late:pitch:0.5");
    for (int k = 0; k <= 20; ++k) {
        const double late = faulty.apply(line(0.1 * k, k)).pitch;
        EXPECT_EQ(late, std::max(0, k - 5));
    }
}

TEST(SensorFault, SwapsSidesAxlesAndTheOrderOfForces)
{
    const Measurement sides = with("swapped:front").apply(line(0.0, 0.0));
    EXPECT_EQ(sides.frontLeft, 0.4);
    EXPECT_EQ(sides.frontRight, 0.3);
    const Measurement axles = with("swapped-axles:angles").apply(line(0.0, 0.0));
    EXPECT_EQ(axles.frontLeft, -0.1);
    EXPECT_EQ(axles.rearRight, 0.4);
    const Measurement forces = with("swapped:forces").apply(line(0.0, 0.0));
    EXPECT_EQ(forces.force, (std::array<double, 6>{6, 5, 4, 3, 2, 1}));
}

TEST(SensorFault, KeepsForcesWithinTheirRange)
{
    const Measurement m = with("offset:forces:-3").apply(line(0.0, 0.0));
    EXPECT_EQ(m.force[0], 0.0);
    EXPECT_EQ(m.force[5], 3.0);
    EXPECT_EQ(with("full-scale:force-6").apply(line(0.0, 0.0)).force[5], absolem().forceSaturation);
}

TEST(SensorFault, MakesScenesOfASensorThatIsStuckSinceTheLast)
{
    FaultyScenes faulty(*sensorFaultFrom("stuck-at-scene:pitch"), absolem(), 1);
    Proprioception s;
    s.pitch = 0.1;
    EXPECT_EQ(faulty.apply(s, 0.0).pitch, 0.1);
    s.pitch = 0.2;
    EXPECT_EQ(faulty.apply(s, 10.0).pitch, 0.1);
    s.pitch = 0.3;
    EXPECT_EQ(faulty.apply(s, 20.0).pitch, 0.2);
}

TEST(SensorFault, LeavesWhatASceneDidNotMeasure)
{
    FaultyScenes faulty(*sensorFaultFrom("zero:all"), absolem(), 1);
    Proprioception s;
    s.front = 0.5;
    s.force[2] = 4.0;
    const Proprioception read = faulty.apply(s, 0.0);
    EXPECT_FALSE(read.frontCurrent);
    EXPECT_FALSE(read.force[0]);
    EXPECT_EQ(read.force[2], 0.0);
    EXPECT_EQ(read.front, 0.0);
}

TEST(SensorFault, SwapsNothingThatASceneDidNotMeasure)
{
    Proprioception s;
    s.frontCurrent = 2.0;
    s.force[0] = 4.0;
    for (const char* fault : {"swapped-axles:currents", "swapped:forces"})
        EXPECT_EQ(FaultyScenes(*sensorFaultFrom(fault), absolem(), 1).apply(s, 0.0), s) << fault;
}

TEST(SensorFault, LosesReadings)
{
    Measurement truth = line(0.0, 0.1);
    truth.turned = 0.5;
    setCurrents(truth, {1.0, 2.0, 3.0, 4.0});
    SideForces sides;
    sides.left.fill(6.0);
    sides.right.fill(2.0);
    setSides(truth, sides);
    EXPECT_EQ(motorCurrents(with("lost:rear-left-current").apply(truth)),
              (MotorCurrents{1.0, 2.0, std::nullopt, 4.0}));
    const Measurement left = with("lost:left-force-2").apply(truth);
    EXPECT_FALSE(left.sides.left[1]);
    EXPECT_EQ(left.force[1], 2.0);
    EXPECT_TRUE(left.missing.none());
    const Measurement both = with("lost:force-2").apply(truth);
    EXPECT_EQ(both.force[1], 0.0);
    EXPECT_EQ(both.missing.count(), 1U);
    const Measurement all = with("lost:all").apply(truth);
    EXPECT_EQ(all.missing.count(), 8U) << "two axles, six elements";
    EXPECT_FALSE(all.travelled || all.turned);
    EXPECT_EQ(all.pitch, 0.1);
    EXPECT_EQ(all.frontRight, 0.4);
}

TEST(SensorFault, LosesFeaturesOfScenes)
{
    Proprioception s;
    s.front = 0.3;
    s.frontCurrent = 2.0;
    s.rearCurrent = 1.0;
    s.force.fill(3.0);
    const auto read = [&s](const char* fault) {
        return FaultyScenes(*sensorFaultFrom(fault), absolem(), 1).apply(s, 0.0);
    };
    for (const char* ofOneSide : {"lost:front-left-current", "lost:right-forces", "lost:odometry"})
        EXPECT_EQ(read(ofOneSide), s) << ofOneSide;
    EXPECT_EQ(missingFeatures(read("lost:front-current")).count(), 1U);
    EXPECT_FALSE(read("lost:force-3").force[2]);
    EXPECT_EQ(missingFeatures(read("lost:all")).count(), 8U);
}

TEST(SensorFault, LeavesAForceThatIsMissing)
{
    Measurement m = line(0.0, 0.0);
    m.force[2] = 0.0;
    m.missing[kFirstForceFeature + 2] = true;
    EXPECT_FALSE(readingsOf(m)[indexOf(Sensor::Force3)]);
    const Measurement read = with("offset:forces:3").apply(m);
    EXPECT_EQ(read.force, (std::array<double, 6>{4, 5, 0, 7, 8, 9}));
    setReading(m, Sensor::Force3, 3.0);
    EXPECT_EQ(m.force[2], 0.0);
}

TEST(SensorFault, LeavesAMotorWithoutACurrent)
{
    Measurement m = line(0.0, 0.0);
    setCurrents(m, {std::nullopt, 1.0, 1.0, 1.0});
    const Measurement read = with("offset:currents:0.5").apply(m);
    EXPECT_EQ(motorCurrents(read), (MotorCurrents{std::nullopt, 1.5, 1.5, 1.5}));
    EXPECT_EQ(read.frontLeftCurrent, 0.0);
    setReading(m, Sensor::FrontLeftCurrent, 3.0);
    EXPECT_EQ(m.frontLeftCurrent, 0.0);
}

}  // namespace
}  // namespace terratact
