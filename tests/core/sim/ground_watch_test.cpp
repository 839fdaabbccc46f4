#include "core/robot/watch/ground_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/robot/watch/driven_ground.h"
#include "core/robot/watch/return_watch.h"
#include "core/robot/watch/stuck_watch.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/sensor_fault.h"
#include "core/sim/watched_drive.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

std::vector<WatchedLine> driveOverRough(double rearAngle, bool comesBack)
{
    std::mt19937_64 rng(5);
    const TerrainProfile ground = isoRoughness(4096e-6, kRandomTerrainLength, rng);
    WatchedStyle style;
    style.flippers.rearAngle = rearAngle;
    style.period = 0.1;
    style.comesBack = comesBack;
    return driveWithTelemetry(absolem(), ground, style, 7);
}

template <class Watch>
bool suspects(const std::vector<WatchedLine>& drive, std::string_view fault, Sensor sensor,
              SensorTrouble trouble)
{
    Watch watch(absolem());
    std::optional<FaultySensors> faulty;
    if (!fault.empty()) faulty.emplace(*sensorFaultFrom(fault), absolem(), 1);
    bool does = false;
    for (const WatchedLine& line : drive) {
        watch.add(faulty ? faulty->apply(line.measurement) : line.measurement);
        for (const SensorSuspicion& s : watch.found())
            does = does || (s.sensor == sensor && s.trouble == trouble);
    }
    return does;
}

TEST(SupportAngle, IsTheTangentToWheelAndTips)
{
    const RobotModel robot = absolem();
    EXPECT_EQ(supportAngle(robot, 0.3), 0.0);
    const double angle = supportAngle(robot, -0.25);
    ASSERT_GT(angle, 0.0);
    // On flat ground the robot then rests with its nose down by the same angle: tips and front
    // wheel touch z = 0.
    const Pose pose{.base = {0.0, 0.0}, .pitch = -angle, .front = 0.5, .rear = -0.25};
    const RobotShape shape = shapeAt(robot, pose);
    EXPECT_NEAR(shape.track.b.z - shape.track.rb, shape.rear.b.z - shape.rear.rb, 0.006);
}

TEST(RearLoad, IsThatOfTheMotorThatIsMeasured)
{
    RearLoad both, one;
    for (int k = 0; k < 20; ++k) {
        Measurement m;
        setCurrents(m, {0.0, 0.0, 0.6, 0.6});
        both.add(m);
        setCurrents(m, {0.0, 0.0, std::nullopt, 0.6});
        one.add(m);
    }
    EXPECT_TRUE(both.isLoaded());
    EXPECT_EQ(one.current(), both.current());
}

TEST(RearLoad, StaysWhereNoCurrentIsMeasured)
{
    RearLoad load;
    Measurement m;
    setCurrents(m, {0.0, 0.0, 0.6, 0.6});
    for (int k = 0; k < 20; ++k) load.add(m);
    const double before = load.current();
    setCurrents(m, {0.0, 0.0, std::nullopt, std::nullopt});
    for (int k = 0; k < 20; ++k) load.add(m);
    EXPECT_EQ(load.current(), before);
}

TEST(DrivenGround, BoundsTheGroundUnderThePathOfTheTracks)
{
    const TerrainProfile flat({{0.0, 0.0}, {6.0, 0.0}});
    WatchedStyle style;
    style.period = 0.1;
    DrivenGround ground(absolem());
    for (const WatchedLine& line : driveWithTelemetry(absolem(), flat, style, 3))
        ground.add(line.measurement, false);
    const double x = ground.pose().base.x;
    EXPECT_FALSE(ground.highestAt(x + 0.5));
    ASSERT_TRUE(ground.highestAt(x - 1.0));
    EXPECT_NEAR(*ground.highestAt(x - 1.0), *ground.highestAt(x), 0.02);
    EXPECT_FALSE(ground.highestAt(x - DrivenGround::kKept - 0.1));
}

TEST(GroundWatch, SuspectsFrontAnglesThatAreTooLarge)
{
    const auto drive = driveOverRough(0.3, false);
    const auto offGround = [&drive](std::string_view fault) {
        return suspects<GroundWatch>(drive, fault, Sensor::FrontRight, SensorTrouble::OffGround);
    };
    EXPECT_FALSE(offGround(""));
    EXPECT_TRUE(offGround("offset:front:0.1745"));
    EXPECT_FALSE(offGround("offset:front:0.0175"));
}

TEST(GroundWatch, SuspectsElementsInTheReverseOrder)
{
    const auto drive = driveOverRough(0.3, false);
    const auto wrongOrder = [&drive](std::string_view fault) {
        return suspects<GroundWatch>(drive, fault, Sensor::Force4, SensorTrouble::WrongOrder);
    };
    EXPECT_FALSE(wrongOrder(""));
    EXPECT_TRUE(wrongOrder("swapped:forces"));
}

TEST(GroundWatch, SuspectsTheSignOfRearAngles)
{
    for (const double rear : {0.5, 0.25}) {
        const auto drive = driveOverRough(rear, false);
        const auto offGround = [&drive](std::string_view fault) {
            return suspects<GroundWatch>(drive, fault, Sensor::RearLeft, SensorTrouble::OffGround);
        };
        EXPECT_FALSE(offGround("")) << rear;
        EXPECT_TRUE(offGround("flipped:rear")) << rear;
    }
}

TEST(GroundWatch, DoesNotJudgeRearAnglesNearTheTracks)
{
    const auto drive = driveOverRough(0.15, false);
    for (const std::string_view fault : {"", "flipped:rear"})
        EXPECT_FALSE(
            suspects<GroundWatch>(drive, fault, Sensor::RearLeft, SensorTrouble::OffGround))
            << fault;
}

TEST(DrivenGround, PassedGroundIsWhatTheWholeTracksCrossed)
{
    DrivenGround ground(absolem());
    Measurement line;
    line.activity = RobotActivity::Driving;
    line.travelled = 0.0;
    ground.add(line, false);
    const double reach = absolem().trackAxle / 2.0 + absolem().trackRadius;
    EXPECT_NEAR(ground.passedFrom(), ground.pose().base.x + reach, 1e-12);
    const double from = ground.passedFrom();
    line.travelled = 0.5;
    ground.add(line, false);
    EXPECT_EQ(ground.passedFrom(), from);
}

TEST(ReturnWatch, ClearsWhenTheShiftIsWithinItsLimit)
{
    const auto drive = driveOverRough(0.5, true);
    ReturnWatch watch(absolem());
    FaultySensors faulty(*sensorFaultFrom("offset:pitch:0.1"), absolem(), 1);
    bool wasSuspected = false;
    for (const WatchedLine& line : drive) {
        watch.add(faulty.apply(line.measurement));
        if (watch.found().empty()) continue;
        wasSuspected = true;
        EXPECT_FALSE(watch.isCleared());
    }
    EXPECT_TRUE(wasSuspected);
    ReturnWatch sound(absolem());
    for (const WatchedLine& line : drive) sound.add(line.measurement);
    EXPECT_TRUE(sound.isCleared());
}

TEST(ReturnWatch, SuspectsAPitchThatIsShifted)
{
    const auto drive = driveOverRough(0.5, true);
    const auto shifted = [&drive](std::string_view fault) {
        return suspects<ReturnWatch>(drive, fault, Sensor::Pitch, SensorTrouble::BothWays);
    };
    EXPECT_FALSE(shifted(""));
    EXPECT_TRUE(shifted("offset:pitch:0.1"));
    EXPECT_TRUE(shifted("offset:pitch:-0.1"));
    EXPECT_TRUE(shifted("offset:pitch:0.0524")) << "3 degrees";
    EXPECT_TRUE(shifted("offset:pitch:-0.0524"));
    EXPECT_TRUE(shifted("drift:pitch:0.1"));
}

TEST(ReturnWatch, DoesNotJudgeWithoutTheCurrentsOfAnAxle)
{
    for (const bool front : {true, false}) {
        auto drive = driveOverRough(0.5, true);
        for (WatchedLine& line : drive) {
            MotorCurrents currents = motorCurrents(line.measurement);
            for (const std::size_t motor : {0U, 1U}) currents[motor + (front ? 0U : 2U)].reset();
            setCurrents(line.measurement, currents);
        }
        EXPECT_FALSE(suspects<ReturnWatch>(drive, "offset:pitch:0.1", Sensor::Pitch,
                                           SensorTrouble::BothWays));
    }
}

TEST(ReturnWatch, DoesNotJudgeOneDirectionAlone)
{
    EXPECT_FALSE(suspects<ReturnWatch>(driveOverRough(0.5, false), "offset:pitch:0.07",
                                       Sensor::Pitch, SensorTrouble::BothWays));
}

TEST(StuckWatch, DoesNotCallOdometryStuckInATurn)
{
    StuckWatch watch;
    Measurement m;
    m.activity = RobotActivity::Driving;
    m.travelled = 1.0;
    for (int k = 0; k < 300; ++k) {
        m.time = 0.05 * k;
        m.pitch = 0.2 * std::sin(0.1 * k);
        m.turned = std::numbers::pi * k / 300.0;
        watch.add(m);
        for (const SensorSuspicion& s : watch.found()) EXPECT_NE(s.sensor, Sensor::Travelled);
    }
}

}  // namespace
}  // namespace terratact
