// Tests which control of a gamepad belongs to which action, and what a stick and a trigger mean.
#include "app/link/gamepad/pad_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "app/link/gamepad/pad_learner.h"

namespace terratact {
namespace {

GamepadState stickAt(double value)
{
    GamepadState state;
    state.connection = 1;
    state[PadAxis::LeftY] = value;
    return state;
}

TEST(PadMapping, defaultGivesEveryActionAnotherControl)
{
    const PadMapping mapping;
    std::set<std::string> used;
    for (std::size_t i = 0; i < kPadActions; ++i) {
        const auto action = static_cast<PadAction>(i);
        ASSERT_TRUE(mapping[action]) << name(action);
        EXPECT_TRUE(suits(action, *mapping[action])) << name(action);
        EXPECT_TRUE(used.insert(textOf(*mapping[action])).second) << name(action);
        EXPECT_EQ(mapping.actionOf(*mapping[action]), action);
    }
    EXPECT_FALSE(mapping.actionOf(PadButton::Y));
}

TEST(PadMapping, isReadAsItIsWritten)
{
    PadMapping mapping;
    EXPECT_EQ(mapping.text(), "stop:rightshoulder second-stop:back dead-man:righttrigger "
                              "drive:lefty- feel-forward:lefttrigger explore:x approve:a refuse:b "
                              "raise-limit:dpup lower-limit:dpdown");
    EXPECT_EQ(PadMapping::parse(mapping.text()), mapping);
    ASSERT_TRUE(mapping.assign(PadAction::Drive, PadStick{PadAxis::RightX, +1}));
    ASSERT_TRUE(mapping.assign(PadAction::Refuse, PadButton::A));
    EXPECT_FALSE(mapping[PadAction::Approve]);
    EXPECT_EQ(PadMapping::parse(mapping.text()), mapping);
}

TEST(PadMapping, refusesATextThatMeansNoMapping)
{
    for (const char* text : {"",
                             "stop",
                             "stop:",
                             ":a",
                             "stop:q",
                             "halt:a",
                             "stop:a stop:b",
                             "stop:a refuse:a",
                             "refuse:a",
                             "second-stop:a",
                             "stop:lefty-",
                             "stop:leftx",
                             "drive:a stop:b",
                             "drive:lefttrigger stop:b",
                             "drive:lefty stop:b",
                             "drive:lefty* stop:b",
                             "stop:a ",
                             "stop:a  refuse:b",
                             "STOP:a",
                             "stop:a\nrefuse:b",
                             "stop:a explore:lefty+"})
        EXPECT_EQ(PadMapping::parse(text).has_value(), std::string(text) == "stop:a ") << text;
}

TEST(PadMapping, takesAControlFromTheOtherActionButNeverFromStop)
{
    PadMapping mapping;
    EXPECT_TRUE(mapping.assign(PadAction::Explore, PadButton::B));
    EXPECT_EQ(mapping[PadAction::Explore], PadControl(PadButton::B));
    EXPECT_FALSE(mapping[PadAction::Refuse]);
    const PadMapping before = mapping;
    for (const PadControl& stop :
         {PadControl(PadButton::RightShoulder), PadControl(PadButton::Back)})
        EXPECT_FALSE(mapping.assign(PadAction::Explore, stop)) << textOf(stop);
    EXPECT_FALSE(mapping.assign(PadAction::Stop, PadButton::Back)) << "STOP has it already";
    EXPECT_TRUE(mapping.assign(PadAction::Stop, PadButton::RightShoulder)) << "its own";
    EXPECT_EQ(mapping, before);
}

TEST(PadMapping, onlyAStickDrivesAndNothingElseIsAStick)
{
    PadMapping mapping;
    EXPECT_FALSE(mapping.assign(PadAction::Drive, PadButton::Y));
    EXPECT_FALSE(mapping.assign(PadAction::Drive, PadAxis::RightTrigger));
    EXPECT_FALSE(mapping.assign(PadAction::Drive, PadStick{PadAxis::RightTrigger, 1}));
    EXPECT_FALSE(mapping.assign(PadAction::Explore, PadStick{PadAxis::RightY, 1}));
    EXPECT_FALSE(mapping.assign(PadAction::Explore, PadAxis::RightY));
    EXPECT_EQ(mapping, PadMapping());
    EXPECT_TRUE(mapping.assign(PadAction::Drive, PadStick{PadAxis::LeftY, +1})) << "turned round";
}

TEST(PadControls, aTriggerNeedsHalfItsWayAndLetsGoBefore)
{
    struct Row {
        double pulled;
        bool was, on;
    };
    for (const Row& row : {Row{0.0, false, false}, Row{0.45, false, false}, Row{0.5, false, false},
                           Row{0.51, false, true}, Row{1.0, false, true}, Row{0.45, true, true},
                           Row{0.4, true, false}, Row{0.0, true, false},
                           Row{std::numeric_limits<double>::quiet_NaN(), true, false}}) {
        GamepadState state;
        state[PadAxis::RightTrigger] = row.pulled;
        EXPECT_EQ(isOn(PadAxis::RightTrigger, state, row.was), row.on) << row.pulled << row.was;
        EXPECT_FALSE(isOn(PadAxis::LeftTrigger, state, row.was));
    }
    GamepadState state;
    state[PadButton::Y] = true;
    EXPECT_TRUE(isOn(PadButton::Y, state, false));
    EXPECT_FALSE(isOn(PadButton::X, state, true));
    EXPECT_FALSE(isOn(PadStick{}, stickAt(-1.0), true));
}

TEST(PadControls, theStickHasADeadZoneAndASpeedLimit)
{
    struct Row {
        double stick, deadZone, limit, speed;
    };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const Row& row :
         {Row{0.0, 0.15, 0.2, 0.0}, Row{-0.15, 0.15, 0.2, 0.0}, Row{0.15, 0.15, 0.2, 0.0},
          Row{-0.151, 0.15, 0.2, 0.005}, Row{-0.575, 0.15, 0.2, 0.1}, Row{0.575, 0.15, 0.2, -0.1},
          Row{-1.0, 0.15, 0.2, 0.2}, Row{1.0, 0.15, 0.2, -0.2}, Row{-1.0, 0.6, 0.6, 0.6},
          Row{-0.8, 0.6, 0.6, 0.3}, Row{-1.0, 0.15, 0.0225, 0.0225},
          Row{-kInfinity, 0.15, 0.2, 0.2}, Row{kNan, 0.15, 0.2, 0.0}}) {
        const PadSettings settings{.deadZone = row.deadZone, .speedLimit = row.limit};
        EXPECT_NEAR(speedOf({PadAxis::LeftY, -1}, stickAt(row.stick), settings), row.speed, 1e-12)
            << row.stick;
        EXPECT_NEAR(speedOf({PadAxis::LeftY, +1}, stickAt(row.stick), settings), -row.speed, 1e-12)
            << row.stick;
    }
}

TEST(PadControls, speedNeverPassesItsLimitAndGrowsWithTheStick)
{
    const PadSettings settings{.deadZone = 0.1, .speedLimit = 0.333};
    double before = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const double speed = speedOf({}, stickAt(-i / 1000.0), settings);
        EXPECT_GE(speed, before);
        EXPECT_LE(speed, settings.speedLimit);
        before = speed;
    }
    EXPECT_DOUBLE_EQ(before, settings.speedLimit);
}

GamepadState with(const std::function<void(GamepadState&)>& set)
{
    GamepadState state;
    state.connection = 1;
    set(state);
    return state;
}

TEST(PadLearner, findsTheControlThatIsTurnedOn)
{
    const GamepadState idle = with([](GamepadState&) {});
    PadLearner stop(PadAction::Stop);
    EXPECT_FALSE(stop.poll(idle));
    EXPECT_FALSE(stop.poll(with([](GamepadState& s) { s[PadAxis::LeftY] = -1.0; }))) << "a stick";
    EXPECT_EQ(stop.poll(with([](GamepadState& s) { s[PadButton::Start] = true; })),
              PadControl(PadButton::Start));
    EXPECT_EQ(stop.poll(with([](GamepadState& s) { s[PadAxis::LeftTrigger] = 0.8; })),
              PadControl(PadAxis::LeftTrigger));

    PadLearner drive(PadAction::Drive);
    EXPECT_FALSE(drive.poll(idle));
    EXPECT_FALSE(drive.poll(with([](GamepadState& s) { s[PadButton::Start] = true; })));
    EXPECT_FALSE(drive.poll(with([](GamepadState& s) { s[PadAxis::RightY] = 0.6; })));
    EXPECT_EQ(drive.poll(with([](GamepadState& s) { s[PadAxis::RightY] = 0.8; })),
              PadControl(PadStick{PadAxis::RightY, +1}));
    EXPECT_EQ(drive.poll(with([](GamepadState& s) { s[PadAxis::RightX] = -0.8; })),
              PadControl(PadStick{PadAxis::RightX, -1}));
}

TEST(PadLearner, aControlThatIsHeldWhenItBeginsMustBeReleasedFirst)
{
    GamepadState held = with([](GamepadState& s) { s[PadButton::A] = true; });
    PadLearner learner(PadAction::Explore);
    EXPECT_FALSE(learner.poll(held));
    EXPECT_FALSE(learner.poll(held));
    held.connection = 2;
    held[PadButton::B] = true;
    EXPECT_FALSE(learner.poll(held)) << "another gamepad";
    held[PadButton::A] = false;
    EXPECT_FALSE(learner.poll(held));
    held[PadButton::A] = true;
    EXPECT_EQ(learner.poll(held), PadControl(PadButton::A));
}

}  // namespace
}  // namespace terratact
