#include "core/robot/watch/side_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_watch.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/sensor_fault.h"
#include "core/sim/watched_drive.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

const std::vector<WatchedLine>& drive()
{
    static const auto made = [] {
        std::mt19937_64 rng(5);
        const TerrainProfile ground = randomVariedTerrain(rng);
        WatchedStyle style;
        style.flippers = randomDriveStyle(rng);
        return driveWithTelemetry(absolem(), ground, style, rng());
    }();
    return made;
}

using Found = std::vector<std::pair<Sensor, SensorTrouble>>;

/// All that stood of single elements at some time of the drive.  No mean of both sides stands at its end.
Found found(std::string_view fault)
{
    SensorWatch watch(absolem());
    FaultySensors faulty(*sensorFaultFrom(fault), absolem(), 1);
    Found all;
    for (const WatchedLine& line : drive()) {
        watch.add(faulty.apply(line.measurement));
        for (const SensorSuspicion& s : watch.standing()) {
            if (!isSideForce(s.sensor)) continue;
            const std::pair one(s.sensor, s.trouble);
            if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
        }
    }
    for (const SensorSuspicion& s : watch.standing()) EXPECT_FALSE(isMeanForce(s.sensor)) << fault;
    return all;
}

TEST(SideWatch, NamesTheElementTheSideAndTheTrouble)
{
    using enum SensorTrouble;
    EXPECT_EQ(found("zero:left-force-6"), (Found{{Sensor::LeftForce6, NoLoad}}));
    EXPECT_EQ(found("flipped:right-force-6"), (Found{{Sensor::RightForce6, NoLoad}}));
    EXPECT_EQ(found("zero:right-force-4"), (Found{{Sensor::RightForce4, NoLoad}}));
    EXPECT_EQ(found("late:left-force-6"), (Found{{Sensor::LeftForce6, Late}}));
    EXPECT_EQ(found("offset:right-force-3:3"), (Found{{Sensor::RightForce3, LoadedFree}}));
    EXPECT_EQ(found("full-scale:left-force-1"), (Found{{Sensor::LeftForce1, LoadedFree}}));
    EXPECT_EQ(found("spikes:right-force-2:10"), (Found{{Sensor::RightForce2, Spikes}}));
}

TEST(SideWatch, NoticesOneSideInTheReverseOrder)
{
    const Found all = found("swapped:left-forces");
    EXPECT_NE(
        std::find(all.begin(), all.end(), std::pair(Sensor::LeftForce6, SensorTrouble::WrongOrder)),
        all.end());
    for (const auto& [sensor, trouble] : all) {
        EXPECT_EQ(trouble, SensorTrouble::WrongOrder);
        EXPECT_NE(sensor, Sensor::RightForce6) << "the side that feels the tip is right";
    }
}

/// A second with raised flippers that feel nothing, before time 0.
void driveRaised(SideWatch& watch)
{
    Measurement line;
    for (std::size_t e = 0; e < kForceElements; ++e) line.sides.left[e] = line.sides.right[e] = 0.0;
    line.activity = RobotActivity::Driving;
    line.frontLeft = line.frontRight = 0.7;
    for (int k = 0; k < 20; ++k) {
        line.time = -1.0 + 0.05 * k;
        watch.add(line);
    }
}

/// Presses of two seconds, with these forces, currents [A] and a difference of the angles [rad].
std::size_t suspicionsOf(const SideForces& sides, std::optional<double> leftCurrent, double angle,
                         std::optional<double> rightCurrent = 2.0)
{
    SideWatch watch;
    std::size_t count = 0;
    Measurement m;
    m.sides = sides;
    setCurrents(m, {leftCurrent, rightCurrent, 0.0, 0.0});
    m.frontLeft = angle;
    driveRaised(watch);
    for (int k = 0; k < 200; ++k) {
        m.time = 0.05 * k;
        m.activity = k % 50 < 40 ? RobotActivity::Pressed : RobotActivity::Pressing;
        watch.add(m);
        count += watch.found().size();
    }
    return count;
}

SideForces all(double force)
{
    SideForces sides;
    sides.left.fill(force);
    sides.right.fill(force);
    return sides;
}

TEST(SideWatch, DoesNotJudgeWhereTheGroundMayDiffer)
{
    SideForces dead = all(5.0);
    dead.left[2] = 0.0;
    EXPECT_GT(suspicionsOf(dead, 2.0, 0.0), 0U);
    EXPECT_EQ(suspicionsOf(dead, 1.0, 0.0), 0U) << "the left motor presses less";
    EXPECT_EQ(suspicionsOf(dead, 2.0, 0.1), 0U) << "the flippers do not lie alike";
    dead.right[3] = 0.0;
    EXPECT_EQ(suspicionsOf(dead, 2.0, 0.0), 0U) << "the contacts differ to both sides";
    dead = all(5.0);
    dead.left[2].reset();
    EXPECT_EQ(suspicionsOf(dead, 2.0, 0.0), 0U) << "it is not measured";
}

TEST(SideWatch, DoesNotJudgeWithoutBothFrontCurrents)
{
    SideForces dead = all(5.0);
    dead.left[2] = 0.0;
    EXPECT_GT(suspicionsOf(dead, 0.2, 0.0, 0.2), 0U);
    EXPECT_EQ(suspicionsOf(dead, std::nullopt, 0.0, 0.2), 0U);
    EXPECT_EQ(suspicionsOf(dead, 0.2, 0.0, std::nullopt), 0U);
    EXPECT_EQ(suspicionsOf(dead, std::nullopt, 0.0, std::nullopt), 0U);
}

TEST(SideWatch, ClearsAnElementThatAgreesAgain)
{
    SideWatch watch;
    driveRaised(watch);
    const auto press = [&](double left, double from) {
        Measurement line;
        line.sides = all(5.0);
        line.sides.left[2] = left;
        line.frontLeftCurrent = line.frontRightCurrent = 2.0;
        bool isFound = false;
        for (int k = 0; k < 50; ++k) {
            line.time = from + 0.05 * k;
            line.activity = k < 40 ? RobotActivity::Pressed : RobotActivity::Pressing;
            watch.add(line);
            isFound = isFound || !watch.found().empty();
        }
        return isFound;
    };
    const SensorSuspicion suspicion{.sensor = Sensor::LeftForce3, .trouble = SensorTrouble::NoLoad};
    EXPECT_FALSE(press(0.0, 0.0));
    EXPECT_TRUE(press(0.0, 10.0));
    EXPECT_FALSE(watch.isCleared(suspicion));
    press(5.0, 20.0);
    press(5.0, 30.0);
    EXPECT_TRUE(watch.isCleared(suspicion));
}

}  // namespace
}  // namespace terratact
