// Tests what a gamepad wants: dead-man, holds, presses, and that a held control means nothing until it was released.
#include "app/link/gamepad/pad_intents.h"

#include <gtest/gtest.h>

#include <functional>

namespace terratact {
namespace {

struct PadFollowing : testing::Test {
    PadFollowing()
    {
        state.connection = 1;
        poll();
    }
    const PadIntents& poll(bool mayAct = true)
    {
        return wanted = follower.poll(state, settings, mayAct);
    }
    void pull(PadAxis axis, double way = 1.0) { state[axis] = way; }
    void press(PadButton button, bool down = true) { state[button] = down; }
    void push(double way) { state[PadAxis::LeftY] = -way; }
    double drive()
    {
        pull(PadAxis::RightTrigger);
        push(0.0);
        poll();
        push(1.0);
        return poll().speed;
    }

    PadFollower follower;
    GamepadState state;
    PadSettings settings;
    PadIntents wanted;
};

TEST_F(PadFollowing, wantsNothingWhileNothingIsTouched)
{
    EXPECT_EQ(poll(), PadIntents());
}

TEST_F(PadFollowing, drivesWhileTheDeadManIsHeld)
{
    EXPECT_DOUBLE_EQ(drive(), settings.speedLimit);
    push(-1.0);
    EXPECT_DOUBLE_EQ(poll().speed, -settings.speedLimit) << "back";
    push(0.0);
    EXPECT_EQ(poll().speed, 0.0);
    push(1.0);
    EXPECT_DOUBLE_EQ(poll().speed, settings.speedLimit);
    pull(PadAxis::RightTrigger, 0.3);
    EXPECT_EQ(poll().speed, 0.0) << "let go";
    pull(PadAxis::RightTrigger);
    EXPECT_EQ(poll().speed, 0.0) << "taken again with the stick pushed";
    EXPECT_TRUE(wanted.stickWasFirst);
    EXPECT_FALSE(poll().stickWasFirst) << "once";
    push(0.1);
    EXPECT_EQ(poll().speed, 0.0);
    push(1.0);
    EXPECT_DOUBLE_EQ(poll().speed, settings.speedLimit);
}

TEST_F(PadFollowing, theStickAloneDrivesNothing)
{
    push(1.0);
    EXPECT_EQ(poll(), PadIntents());
}

TEST_F(PadFollowing, noStickMeansNoDrive)
{
    ASSERT_TRUE(PadMapping::parse("stop:back dead-man:righttrigger"));
    settings.mapping = *PadMapping::parse("stop:back dead-man:righttrigger");
    poll();
    EXPECT_EQ(drive(), 0.0);
}

TEST_F(PadFollowing, pressesCountOnceAndHoldsAsLongAsTheyLast)
{
    struct Row {
        PadButton button;
        bool PadIntents::*intent;
        bool isHeld;
    };
    for (const Row& row : {Row{PadButton::X, &PadIntents::explore, false},
                           Row{PadButton::B, &PadIntents::refuse, false},
                           Row{PadButton::Up, &PadIntents::raiseLimit, false},
                           Row{PadButton::Down, &PadIntents::lowerLimit, false},
                           Row{PadButton::RightShoulder, &PadIntents::stop, false},
                           Row{PadButton::Back, &PadIntents::stop, false},
                           Row{PadButton::A, &PadIntents::approve, true}}) {
        PadIntents only;
        only.*row.intent = true;
        press(row.button);
        EXPECT_EQ(poll(), only) << name(row.button);
        EXPECT_EQ(poll(), row.isHeld ? only : PadIntents()) << name(row.button);
        press(row.button, false);
        EXPECT_EQ(poll(), PadIntents()) << name(row.button);
        press(row.button);
        EXPECT_EQ(poll(), only) << name(row.button) << " again";
        press(row.button, false);
        poll();
    }
    pull(PadAxis::LeftTrigger);
    EXPECT_TRUE(poll().feelForward);
    EXPECT_TRUE(poll().feelForward);
    pull(PadAxis::LeftTrigger, 0.0);
    EXPECT_FALSE(poll().feelForward);
}

TEST_F(PadFollowing, stopCountsWhileNothingElseMayAct)
{
    poll(false);
    press(PadButton::Back);
    press(PadButton::X);
    pull(PadAxis::LeftTrigger);
    PadIntents stop;
    stop.stop = true;
    EXPECT_EQ(poll(false), stop);
    EXPECT_EQ(poll(false), PadIntents());
    EXPECT_EQ(poll(true), PadIntents()) << "held since before";
}

TEST_F(PadFollowing, aSecondStopWhileTheFirstIsHeldCounts)
{
    press(PadButton::Back);
    EXPECT_TRUE(poll().stop);
    press(PadButton::RightShoulder);
    EXPECT_TRUE(poll().stop);
}

/// Holds every control and drives. An event must then cancel each control until it is released.
struct HeldThrough : PadFollowing {
    void holdAll()
    {
        drive();
        pull(PadAxis::LeftTrigger);
        for (const PadButton button :
             {PadButton::X, PadButton::A, PadButton::B, PadButton::Up, PadButton::Down})
            press(button);
        poll();
        ASSERT_TRUE(wanted.approve && wanted.feelForward && wanted.speed > 0.0);
    }
    /// Each control counts again once it was released.
    void expectNothingUntilReleased()
    {
        for (int i = 0; i < 3; ++i) EXPECT_EQ(poll(), PadIntents());
        push(0.0);
        poll();
        push(1.0);
        EXPECT_EQ(poll(), PadIntents()) << "the stick alone is no new hold";
        press(PadButton::A, false);
        poll();
        press(PadButton::A);
        EXPECT_TRUE(poll().approve);
        EXPECT_FALSE(wanted.feelForward || wanted.explore || wanted.speed != 0.0);
        pull(PadAxis::RightTrigger, 0.0);
        poll();
        EXPECT_GT(drive(), 0.0);
        pull(PadAxis::LeftTrigger, 0.0);
        poll();
        pull(PadAxis::LeftTrigger);
        EXPECT_TRUE(poll().feelForward);
    }
};

TEST_F(HeldThrough, theLossOfThePadLetsGoOfAllAndItsReturnHoldsNothing)
{
    ASSERT_NO_FATAL_FAILURE(holdAll());
    const GamepadState held = state;
    state = GamepadState();
    EXPECT_EQ(poll(), PadIntents());
    state = held;
    state.connection = 2;
    expectNothingUntilReleased();
}

TEST_F(HeldThrough, anotherPadHoldsNothing)
{
    ASSERT_NO_FATAL_FAILURE(holdAll());
    press(PadButton::Back);
    poll();
    press(PadButton::RightShoulder);
    state.connection = 7;
    expectNothingUntilReleased();
    EXPECT_FALSE(poll().stop) << "STOP was held when the pad appeared";
    press(PadButton::Back, false);
    poll();
    press(PadButton::Back);
    EXPECT_TRUE(poll().stop);
}

TEST_F(HeldThrough, aWindowThatIsLeftAndComesBackHoldsNothing)
{
    ASSERT_NO_FATAL_FAILURE(holdAll());
    EXPECT_EQ(poll(false), PadIntents());
    expectNothingUntilReleased();
}

TEST_F(HeldThrough, aFrozenWindowHoldsNothing)
{
    ASSERT_NO_FATAL_FAILURE(holdAll());
    follower.release();
    expectNothingUntilReleased();
}

TEST_F(HeldThrough, anotherMappingHoldsNothing)
{
    ASSERT_NO_FATAL_FAILURE(holdAll());
    ASSERT_TRUE(settings.mapping.assign(PadAction::LowerLimit, PadButton::Y));
    expectNothingUntilReleased();
}

TEST(PadFollowingAtFirst, aControlThatIsHeldWhenThePadAppearsMeansNothing)
{
    PadFollower follower;
    GamepadState state;
    EXPECT_EQ(follower.poll(state, {}, true), PadIntents());
    state.connection = 1;
    state[PadButton::Back] = state[PadButton::A] = true;
    state[PadAxis::RightTrigger] = state[PadAxis::LeftTrigger] = 1.0;
    EXPECT_EQ(follower.poll(state, {}, true), PadIntents());
    state[PadAxis::LeftY] = -1.0;
    EXPECT_EQ(follower.poll(state, {}, true), PadIntents());
}

TEST_F(PadFollowing, releaseKeepsStop)
{
    press(PadButton::Back);
    poll();
    follower.release();
    EXPECT_FALSE(poll().stop) << "it is the same press";
    press(PadButton::Back, false);
    follower.release();
    poll();
    press(PadButton::Back);
    follower.release();
    EXPECT_TRUE(poll().stop);
}

}  // namespace
}  // namespace terratact
