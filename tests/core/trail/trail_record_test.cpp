#include "core/trail/trail_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/kinematics.h"
#include "tests/core/trail/trail_record_fixture.h"

namespace terratact {
namespace {

TEST_F(TrailRecordTest, NothingIsKnownAtTheBegin)
{
    line.pitch = 0.1;
    line.roll = -0.05;
    const TrailHistory history = record.before(line);
    EXPECT_EQ(history.way, 0.0);
    for (const double pitch : history.pitch) EXPECT_EQ(pitch, 0.1);
    for (const double roll : history.roll) EXPECT_EQ(roll, -0.05);
    for (const TrailGround& ground : history.ground)
        for (const double load : ground.load) EXPECT_EQ(load, 0.0);
}

TEST_F(TrailRecordTest, KnowsItsWayUpToTheReach)
{
    drive(0.6);
    EXPECT_NEAR(record.length(), 0.6, 1e-9);
    EXPECT_NEAR(record.before(line).way, 0.6, 1e-9);
    EXPECT_NEAR(record.before(line, 0.25).way, 0.25, 1e-9);
    drive(6.0);
    EXPECT_NEAR(record.length(), TrailRecord::kLength, 1e-9);
    EXPECT_EQ(record.before(line).way, kTrailReach);
}

TEST_F(TrailRecordTest, ReturnsThePitchAlongTheWay)
{
    drive(0.6);
    line.pitch = 0.2;
    drive(0.3);
    const TrailHistory history = record.before(line);
    EXPECT_NEAR(history.pitch[0], 0.2, 1e-12);  // 0.1 m behind
    EXPECT_NEAR(history.pitch[1], 0.2, 1e-12);
    EXPECT_NEAR(history.pitch[4], 0.0, 1e-12);  // 0.5 m behind
}

TEST_F(TrailRecordTest, ReversingFindsThePlaceAgain)
{
    drive(0.6);
    line.pitch = 0.2;
    drive(0.3);
    line.pitch = 0.0;
    drive(-0.6);
    const TrailHistory history = record.before(line);
    EXPECT_NEAR(history.pitch[0], 0.0, 1e-12);
    EXPECT_NEAR(history.pitch[2], 0.0, 1e-12);
}

TEST_F(TrailRecordTest, TheBodyThatPassedBoundsTheGround)
{
    drive(1.5);
    const TrailHistory history = record.before(line);
    for (const std::size_t bin : {std::size_t{0}, std::size_t{2}, std::size_t{5}})
        EXPECT_NEAR(history.ground[0].lowest[bin], groundHeight(), 1e-3) << bin;
    const double ahead = record.before(line).ground[0].lowest[8];
    drive(-0.4);  // the tracks have been farther ahead than now
    EXPECT_NEAR(record.before(line).ground[0].lowest[8], ahead, 1e-9) << "as on the way there";
}

TEST_F(TrailRecordTest, APressIsFoundWhereItWas)
{
    drive(0.6);
    const Measurement scene = press();
    const Pose pose = poseInDem(robot, scene.pitch, 0.0, scene.rearLeft);
    const Vec2 element = elementPosition(robot, pose, robot.elementShare[4]);
    record.addScene(scene);
    EXPECT_EQ(record.before(scene).ground[0].load[8], 0.0) << "a scene is no memory of itself";
    EXPECT_EQ(record.before(scene).presses, 0);
    drive(0.3);
    const TrailHistory history = record.before(line);
    EXPECT_EQ(history.presses, 1);
    EXPECT_EQ(record.before(line, 0.2).presses, 0) << "farther back than the history tells";
    const double x = element.x - 0.3;
    for (std::size_t bin = 0; bin < kTrailBins; ++bin) {
        const double away = std::abs(x - binCentre(static_cast<int>(bin)));
        const double load = 5.0 * std::max(1.0 - away / 0.1, 0.0);
        EXPECT_NEAR(history.ground[0].load[bin], load, 1e-6) << bin;
        if (load > 0.1) {
            EXPECT_NEAR(history.ground[0].pressed[bin], element.z, 1e-6) << bin;
        }
    }
}

/// The networks know ways forward: a way that turns back must look like one.
TEST_F(TrailRecordTest, AWayBackLeavesTheHistoryOfTheWayThere)
{
    drive(0.9);
    record.addScene(press());
    drive(0.3);
    const TrailHistory there = record.before(line);
    line.pitch = 0.05;
    line.frontLeft = line.frontRight = -0.5;  // tips far below the ground there
    drive(0.6);
    record.addScene(press());
    record.addArm(press(), {.bin = 4, .height = -0.2});
    line.frontLeft = line.frontRight = 0.7;
    drive(-0.6);
    line.pitch = 0.0;
    const TrailHistory back = record.before(line);
    EXPECT_NEAR(back.way, there.way, 1e-9);
    EXPECT_EQ(back.presses, there.presses) << "the press ahead is not of this way";
    for (std::size_t k = 0; k < kTrailPlaces; ++k)
        EXPECT_NEAR(back.pitch[k], there.pitch[k], 1e-12) << k;
    for (std::size_t i = 0; i < kTrailBins; ++i)
        EXPECT_NEAR(back.ground[0].load[i], there.ground[0].load[i], 0.01) << i;
    EXPECT_GT(back.ground[0].armSd[10], 0.0) << "the arm's reading counts wherever it lies";
    drive(-2.4);
    EXPECT_EQ(record.before(line).way, 0.0) << "behind the begin nothing is known";
    EXPECT_EQ(record.length(), 0.0);
}

TEST_F(TrailRecordTest, RollLiftsTheGroundOfOneSide)
{
    line.roll = 0.1;
    drive(1.5);
    const TrailHistory history = record.before(line);
    const double left = history.ground[1].lowest[3], right = history.ground[2].lowest[3];
    EXPECT_NEAR(left - right, 2.0 * robot.lateral.trackY * std::sin(0.1), 2e-3);
    Measurement other = line;
    other.roll = -0.1;
    TrailRecord mirrored(robot);
    other.travelled = 2.0;
    for (int k = 0; k <= 50; ++k) {
        mirrored.add(other);
        other.time += 0.1;
        *other.travelled += 0.03;
    }
    *other.travelled -= 0.03;
    EXPECT_NEAR(mirrored.before(other).ground[2].lowest[3], left, 1e-9);
}

TEST_F(TrailRecordTest, ABreakForgets)
{
    drive(1.0);
    record.addScene(press());
    line.time += kMaxSilence + 0.1;
    record.add(line);
    EXPECT_EQ(record.why(), SectionStart::TelemetryGap);
    EXPECT_EQ(record.before(line).way, 0.0);
    drive(0.3);
    Measurement late = line;
    late.time += kMaxSilence + 0.1;
    EXPECT_EQ(record.before(late).way, 0.0) << "the silence before a scene counts, too";
    const TrailHistory history = record.before(line);
    for (const double load : history.ground[0].load) EXPECT_EQ(load, 0.0);
    EXPECT_NEAR(history.way, 0.3, 1e-9);

    for (int k = 0; k < 6; ++k) {
        line.time += 0.1;
        *line.turned += 0.05;
        record.add(line);
    }
    EXPECT_EQ(record.why(), SectionStart::Turned);
    EXPECT_LT(record.before(line).way, 0.05);

    line.travelled.reset();
    record.add(line);
    EXPECT_EQ(record.why(), SectionStart::NoOdometry);
    EXPECT_EQ(record.length(), 0.0);
    EXPECT_EQ(record.before(line).way, 0.0);
}

TEST_F(TrailRecordTest, ARestartedOdometryForgets)
{
    drive(-1.7);
    record.addScene(pressFlat());
    record.addArm(pressFlat(), {.bin = 10, .height = -0.6, .sd = 0.01});
    line.time += 0.05;
    line.travelled = 0.0;  // from 0.3 m
    record.add(line);
    EXPECT_EQ(record.why(), SectionStart::OdometryJump);
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_NEAR(history.way, 0.1, 1e-9);
    for (const TrailGround& ground : history.ground) {
        EXPECT_TRUE(feelsNothing(ground));
        EXPECT_EQ(ground.armSd[9], 0.0);
    }
}

TEST_F(TrailRecordTest, AFlickerWhileStandingForgetsNothing)
{
    drive(0.6);
    record.addScene(pressFlat());
    record.addArm(pressFlat(), {.bin = 10, .height = -0.6, .sd = 0.01});
    TrailRecord still = record;
    for (int k = 0; k < 900; ++k) {  // 45 s of a probe; the odometry counts in millimetres
        line.time += 0.05;
        still.add(line);
        Measurement flickering = line;
        *flickering.travelled += k % 2 == 0 ? 1e-3 : -1e-3;
        record.add(flickering);
    }
    line.time += 0.05;
    *line.travelled += 0.1;
    record.add(line);
    still.add(line);
    const TrailHistory history = record.before(line), expected = still.before(line);
    EXPECT_EQ(history.presses, 1);
    EXPECT_FALSE(feelsNothing(history.ground[0]));
    EXPECT_NEAR(history.ground[0].armSd[9], expected.ground[0].armSd[9], 1e-3);
}

TEST_F(TrailRecordTest, MoreTelemetryGivesTheSameHistory)
{
    TrailRecord dense(robot);
    Measurement at = line;
    dense.add(at);
    for (int k = 0; k < 500; ++k) {
        at.time += 0.01;
        *at.travelled += 0.003;
        dense.add(at);
    }
    drive(1.5);
    const TrailHistory a = record.before(line), b = dense.before(at);
    EXPECT_NEAR(a.way, b.way, 1e-6);
    for (std::size_t bin = 0; bin < kTrailBins; ++bin)
        if (std::isfinite(a.ground[0].lowest[bin])) {
            EXPECT_NEAR(a.ground[0].lowest[bin], b.ground[0].lowest[bin], 2e-3) << bin;
        }
}

}  // namespace
}  // namespace terratact
