#include "core/atem/contact_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/atem/contact_cue.h"
#include "core/atem/speed_meter.h"
#include "core/infer/estimate/touch.h"

namespace terratact {
namespace {

constexpr double kThreshold = 2.0;

/// Gives a watch one line of telemetry each 50 ms.
struct Contacts : testing::Test {
    ContactWatch watch{kThreshold};
    Measurement line;

    Contacts()
    {
        SideForces forces;
        forces.left.fill(0.0);
        forces.right.fill(0.0);
        setSides(line, forces);
    }
    /// Returns true if left element `e` touches after a line with this force on it.
    bool touches(double newtons, std::size_t e = 4, double after = 0.05)
    {
        SideForces forces = line.sides;
        forces.left.at(e) = newtons;
        setSides(line, forces);
        line.time += after;
        return watch.add(line).flippers[indexOf(Flipper::FrontLeft)].at(e).touches;
    }
};

TEST_F(Contacts, beginAboveTheThresholdAndNotAtIt)
{
    EXPECT_FALSE(touches(kThreshold));
    EXPECT_TRUE(touches(std::nextafter(kThreshold, 3.0)));
}

TEST_F(Contacts, endThreeSdOfTheNoiseBelowIt)
{
    ASSERT_TRUE(touches(2.1));
    EXPECT_TRUE(touches(kThreshold - kLoadThreshold + 0.01)) << "it holds";
    EXPECT_FALSE(touches(kThreshold - kLoadThreshold));
    EXPECT_FALSE(touches(1.9)) << "it begins above the threshold only";
}

TEST_F(Contacts, endAtHalfOfASmallThreshold)
{
    watch.setThreshold(0.4);
    ASSERT_TRUE(touches(0.5));
    EXPECT_TRUE(touches(0.21));
    EXPECT_FALSE(touches(0.2));
}

TEST_F(Contacts, areKeptForEachElementAlone)
{
    ASSERT_TRUE(touches(3.0, 4));
    EXPECT_FALSE(touches(1.5, 3)) << "a neighbour gets no hysteresis";
    const auto& state = watch.state();
    EXPECT_EQ(state.strongest(), (ElementContact{Flipper::FrontLeft, 4, 3.0}));
    EXPECT_FALSE(state.strongest(Flipper::FrontRight));
    EXPECT_TRUE(touches(7.0, 3));
    EXPECT_EQ(watch.state().strongest(Flipper::FrontLeft)->element, 3);
}

TEST_F(Contacts, resetAfterSilenceAndAfterAJumpOfTheClock)
{
    ASSERT_TRUE(touches(3.0));
    EXPECT_FALSE(touches(1.5, 4, kMaxSilence + 0.1)) << "it may have moved";
    ASSERT_TRUE(touches(3.0));
    EXPECT_FALSE(touches(1.5, 4, -0.2));
    ASSERT_TRUE(touches(3.0));
    watch.clear();
    EXPECT_FALSE(watch.state().touches());
    EXPECT_FALSE(touches(1.5));
}

TEST_F(Contacts, ofAnUnknownElementAreNone)
{
    ASSERT_TRUE(touches(3.0));
    line.sides.left[4].reset();
    setSides(line, line.sides);
    line.time += 0.05;
    EXPECT_FALSE(watch.add(line).touches());
    EXPECT_TRUE(watch.state().knows(Flipper::FrontLeft));
    EXPECT_FALSE(watch.state().knows(Flipper::RearLeft));
}

TEST_F(Contacts, ofOldRecordingsAreOfBothSides)
{
    line.sides = {};
    line.force[5] = 9.0;
    const FlipperContacts& state = watch.add(line);
    EXPECT_FALSE(state.sidesKnown);
    EXPECT_EQ(state.strongest(Flipper::FrontLeft)->element, 5);
    EXPECT_EQ(state.strongest(Flipper::FrontRight)->element, 5);
}

TEST_F(Contacts, ofTheRearFlippersCount)
{
    line.rearSides.right[0] = 4.0;
    EXPECT_EQ(watch.add(line).strongest(), (ElementContact{Flipper::RearRight, 0, 4.0}));
}

TEST(ContactWatch, refusesAThresholdThatIsNone)
{
    for (const double bad :
         {-0.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(ContactWatch{bad}, std::invalid_argument) << bad;
}

FlipperContacts contact(int element, double force)
{
    FlipperContacts state;
    state.flippers[indexOf(Flipper::FrontRight)].at(static_cast<std::size_t>(element)) = {force,
                                                                                          true};
    return state;
}

TEST(ContactTone, risesToTheTipAndStaysBelowTheAlarm)
{
    double last = 0.0;
    for (int e = 0; e < kForceElements; ++e) {
        const double pitch = contactTone(contact(e, 5.0))->pitch;
        EXPECT_GT(pitch, 1.15 * last);
        last = pitch;
    }
    EXPECT_LT(last, 0.7 * 880.0);
}

TEST(ContactTone, ticksFasterTheHarderItPresses)
{
    EXPECT_DOUBLE_EQ(contactTone(contact(3, 0.5))->period, kSlowestTick);
    EXPECT_DOUBLE_EQ(contactTone(contact(3, 50.0))->period, kFastestTick);
    EXPECT_GT(contactTone(contact(3, 4.0))->period, contactTone(contact(3, 5.0))->period);
    EXPECT_FALSE(contactTone({}));
}

/// Returns the times of the ticks, polled each 20 ms.
std::vector<double> ticks(ContactCue& cue, const FlipperContacts& state, bool moves, double from,
                          double to)
{
    std::vector<double> times;
    for (double t = from; t < to - 1e-9; t += 0.02)
        if (cue.poll(state, moves, t)) times.push_back(t);
    return times;
}

TEST(ContactCue, ticksAtOnceAndThenByTheForce)
{
    ContactCue cue;
    EXPECT_TRUE(ticks(cue, {}, true, 0.0, 1.0).empty()) << "nothing touches";
    const auto soft = ticks(cue, contact(2, 2.0), true, 1.0, 3.0);
    ASSERT_EQ(soft.size(), 3U);
    EXPECT_DOUBLE_EQ(soft[0], 1.0);
    EXPECT_NEAR(soft[1] - soft[0], kSlowestTick, 0.021);
    EXPECT_GT(ticks(cue, contact(2, 30.0), true, 3.0, 5.0).size(), 12U);
}

TEST(ContactCue, ticksOnceWhileTheRobotStands)
{
    ContactCue cue;
    EXPECT_EQ(ticks(cue, contact(2, 9.0), false, 0.0, 5.0).size(), 1U);
    EXPECT_EQ(ticks(cue, contact(4, 9.0), false, 5.0, 10.0).size(), 1U) << "another element";
    EXPECT_EQ(ticks(cue, {}, false, 10.0, 11.0).size(), 0U);
    EXPECT_EQ(ticks(cue, contact(4, 9.0), false, 11.0, 12.0).size(), 1U) << "a new contact";
}

TEST(ContactCue, isNotFasterWhereTheElementFlutters)
{
    ContactCue cue;
    int count = 0;
    for (int i = 0; i < 100; ++i)  // 1 s
        count += cue.poll(contact(3 + i % 2, 2.0), false, 0.01 * i) ? 1 : 0;
    EXPECT_LE(count, 9);
}

Measurement at(double time, std::optional<double> way)
{
    Measurement m;
    m.time = time;
    m.travelled = way;
    return m;
}

TEST(SpeedMeter, isTheWayOfTheWindow)
{
    SpeedMeter meter;
    EXPECT_FALSE(meter.speed());
    meter.add(at(0.0, 1.0));
    EXPECT_FALSE(meter.speed());
    for (int i = 1; i <= 20; ++i) meter.add(at(0.05 * i, 1.0 + 0.01 * i));
    EXPECT_NEAR(*meter.speed(), 0.2, 1e-9);
    for (int i = 21; i <= 40; ++i) meter.add(at(0.05 * i, 1.2));
    EXPECT_EQ(*meter.speed(), 0.0) << "it stands";
    for (int i = 41; i <= 60; ++i) meter.add(at(0.05 * i, 1.2 - 0.005 * (i - 40)));
    EXPECT_NEAR(*meter.speed(), -0.1, 1e-9);
}

TEST(SpeedMeter, isZeroSoonAfterTheRobotStops)
{
    SpeedMeter meter;
    for (int i = 0; i <= 20; ++i) meter.add(at(0.05 * i, 0.042 * i));
    const double stopped = 1.0;
    for (int i = 1; i <= 3; ++i) meter.add(at(stopped + 0.05 * i, 0.84));
    EXPECT_EQ(*meter.speed(), 0.0);
    meter.add(at(stopped + 0.2, 0.86));
    EXPECT_LE(*meter.speed(), 0.2) << "the drive before the stop does not count";
}

TEST(SpeedMeter, readsSlowDrivesOfOdometryInSteps)
{
    SpeedMeter meter;  // 0.03 m/s, 1 mm a step, 100 lines a second
    for (int i = 0; i <= 300; ++i) {
        meter.add(at(0.01 * i, std::floor(0.3 * i) * 1e-3));
        if (i >= 30) {
            EXPECT_NEAR(*meter.speed(), 0.03, 0.005) << i;
        }
    }
}

TEST(SpeedMeter, aResetOfTheOdometryIsNoSpeed)
{
    SpeedMeter meter;
    for (int i = 0; i <= 10; ++i) meter.add(at(0.05 * i, 7.0 + 0.01 * i));
    meter.add(at(0.55, 0.0));
    EXPECT_FALSE(meter.speed());
    meter.add(at(0.6, 0.01));
    EXPECT_NEAR(*meter.speed(), 0.2, 1e-9);
    meter.add(at(0.65, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(meter.speed());
}

TEST(SpeedMeter, resetsWithoutOdometryAndAfterSilence)
{
    SpeedMeter meter;
    const auto drive = [&] {
        meter.clear();
        meter.add(at(0.0, 0.0));
        meter.add(at(0.1, 0.02));
        EXPECT_TRUE(meter.speed());
    };
    drive();
    meter.add(at(0.2, std::nullopt));
    EXPECT_FALSE(meter.speed());
    drive();
    meter.add(at(0.1 + kMaxSilence + 0.1, 5.0));
    EXPECT_FALSE(meter.speed());
    drive();
    meter.add(at(-3.0, 0.0));
    EXPECT_FALSE(meter.speed());
}

}  // namespace
}  // namespace terratact
