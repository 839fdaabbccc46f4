#include "core/atem/arming.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace terratact {
namespace {

using Phase = ArmingPhase;
using Cause = DisarmCause;

constexpr ArmingLimits kLimits;

/// No fault and no event.
ArmingInput calm(double now)
{
    return {.now = now, .operatorPresent = true, .linkGoodFor = 10.0, .robotEpoch = 5};
}

struct Row {
    const char* what;
    ArmingState from;
    std::function<void(ArmingInput&)> happens;
    Phase phase;
    Cause cause;
};

const ArmingState kDisarmed{.since = 90.0};
const ArmingState kConfirming{.phase = Phase::Confirming, .since = 99.0};
const ArmingState kRequested{.phase = Phase::Requested, .since = 99.5};
const ArmingState kArmed{.phase = Phase::Armed, .since = 50.0, .epoch = 5};

TEST(Arming, followsEveryArrowOfItsDiagram)
{
    using In = ArmingInput;
    const auto robotArmed = [](In& in) { in.robotArmed = true; };
    const std::vector<Row> rows{
        {"nothing", kDisarmed, [](In&) {}, Phase::Disarmed, Cause::None},
        {"a second action without a first", kDisarmed, [](In& in) { in.confirmed = true; },
         Phase::Disarmed, Cause::None},
        {"the first action", kDisarmed, [](In& in) { in.wanted = true; }, Phase::Confirming,
         Cause::None},
        {"both actions at once", kDisarmed, [](In& in) { in.wanted = in.confirmed = true; },
         Phase::Confirming, Cause::None},
        {"a link good for just long enough", kDisarmed,
         [](In& in) { in.wanted = true, in.linkGoodFor = 1.0; }, Phase::Confirming, Cause::None},
        {"a link not good for long enough", kDisarmed,
         [](In& in) { in.wanted = true, in.linkGoodFor = 0.999; }, Phase::Disarmed,
         Cause::LinkNotGood},
        {"a link of NaN", kDisarmed,
         [](In& in) { in.wanted = true, in.linkGoodFor = std::nan(""); }, Phase::Disarmed,
         Cause::LinkNotGood},
        {"a robot that is armed already", kDisarmed,
         [](In& in) { in.wanted = in.robotArmed = true; }, Phase::Disarmed, Cause::AlreadyArmed},
        {"a latched stop", kDisarmed, [](In& in) { in.wanted = in.stopLatched = true; },
         Phase::Disarmed, Cause::Stop},
        {"no operator", kDisarmed, [](In& in) { in.wanted = true, in.operatorPresent = false; },
         Phase::Disarmed, Cause::OperatorAbsent},
        {"a foreign sender", kDisarmed, [](In& in) { in.wanted = in.foreignSender = true; },
         Phase::Disarmed, Cause::ForeignSender},

        {"waiting for the second action", kConfirming, [](In&) {}, Phase::Confirming, Cause::None},
        {"the first action again", kConfirming, [](In& in) { in.wanted = true; }, Phase::Confirming,
         Cause::None},
        {"the second action", kConfirming, [](In& in) { in.confirmed = true; }, Phase::Requested,
         Cause::None},
        {"the last moment", kConfirming, [](In& in) { in.now = 103.999, in.confirmed = true; },
         Phase::Requested, Cause::None},
        {"too late", kConfirming, [](In& in) { in.now = 104.0, in.confirmed = true; },
         Phase::Disarmed, Cause::ConfirmTimeout},
        {"armed by somebody else meanwhile", kConfirming, robotArmed, Phase::Disarmed,
         Cause::AlreadyArmed},

        {"waiting for the robot", kRequested, [](In&) {}, Phase::Requested, Cause::None},
        {"the robot arms", kRequested, robotArmed, Phase::Armed, Cause::None},
        {"the robot arms without an epoch", kRequested,
         [](In& in) { in.robotArmed = true, in.robotEpoch = 0; }, Phase::Requested, Cause::None},
        {"the robot does not arm", kRequested, [](In& in) { in.now = 100.5; }, Phase::Disarmed,
         Cause::RequestTimeout},

        {"armed and calm", kArmed, robotArmed, Phase::Armed, Cause::None},
        {"the robot disarms", kArmed, [](In&) {}, Phase::Disarmed, Cause::RobotDisarmed},
        {"the robot has rebooted and is armed by another", kArmed,
         [](In& in) { in.robotArmed = true, in.robotEpoch = 6; }, Phase::Disarmed,
         Cause::EpochChanged},
    };
    for (const Row& row : rows) {
        ArmingInput in = calm(100.0);
        row.happens(in);
        const ArmingState next = nextArming(row.from, in, kLimits);
        EXPECT_EQ(next.phase, row.phase) << row.what;
        EXPECT_EQ(next.cause, row.cause) << row.what;
        const bool moved = next.phase != row.from.phase || next.cause != row.from.cause;
        EXPECT_EQ(next.since, moved ? in.now : row.from.since) << row.what;
        EXPECT_EQ(next.epoch, next.phase == Phase::Armed ? 5 : 0) << row.what;
    }
}

TEST(Arming, anyFaultDisarmsAtOnce)
{
    using In = ArmingInput;
    const std::vector<std::pair<Cause, std::function<void(In&)>>> faults{
        {Cause::Stop, [](In& in) { in.stopLatched = true; }},
        {Cause::Operator, [](In& in) { in.disarmed = true; }},
        {Cause::OperatorAbsent, [](In& in) { in.operatorPresent = false; }},
        {Cause::ForeignSender, [](In& in) { in.foreignSender = true; }},
        {Cause::LinkNotGood, [](In& in) { in.linkGoodFor = 0.0; }},
        {Cause::LinkNotGood, [](In& in) { in.linkGoodFor = std::nan(""); }},
    };
    for (const ArmingState& state : {kConfirming, kRequested, kArmed})
        for (const auto& [cause, happens] : faults) {
            ArmingInput in = calm(100.0);
            in.robotArmed = in.confirmed = true;
            happens(in);
            EXPECT_EQ(nextArming(state, in, kLimits), (ArmingState{.cause = cause, .since = 100.0}))
                << describe(state.phase).english << ", " << describe(cause).english;
        }
}

TEST(Arming, neverArmsAutomatically)
{
    ArmingState state = kArmed;
    ArmingInput in = calm(100.0);
    in.robotArmed = true;
    in.linkGoodFor = 0.0;
    state = nextArming(state, in, kLimits);
    ASSERT_EQ(state.phase, Phase::Disarmed);
    in.linkGoodFor = 100.0;
    for (in.now = 101.0; in.now < 200.0; in.now += 0.05) {
        in.confirmed = true;
        in.robotArmed = !in.robotArmed;
        state = nextArming(state, in, kLimits);
        ASSERT_EQ(state.phase, Phase::Disarmed);
        ASSERT_EQ(state.cause, Cause::LinkNotGood) << "and keeps saying why";
    }
}

TEST(Arming, refusesTimesThatAreNotFinite)
{
    EXPECT_THROW(static_cast<void>(nextArming({}, calm(std::nan("")), kLimits)),
                 std::invalid_argument);
    EXPECT_THROW(
        static_cast<void>(nextArming({.phase = static_cast<Phase>(9)}, calm(1.0), kLimits)),
        std::invalid_argument);
}

TEST(Arming, hasWordsForEverything)
{
    for (int i = 0; i <= static_cast<int>(Phase::Armed); ++i)
        EXPECT_STRNE(describe(static_cast<Phase>(i)).english, "");
    for (int i = 0; i <= static_cast<int>(Cause::EpochChanged); ++i)
        EXPECT_STRNE(describe(static_cast<Cause>(i)).english, "");
    EXPECT_THROW(static_cast<void>(describe(static_cast<Phase>(4)).english), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(describe(static_cast<Cause>(99)).english),
                 std::invalid_argument);
}

TEST(Arming, namesAreReadBack)
{
    for (int i = 0; i <= static_cast<int>(Phase::Armed); ++i)
        EXPECT_EQ(armingPhaseFromName(name(static_cast<Phase>(i))), static_cast<Phase>(i));
    for (int i = 0; i <= static_cast<int>(Cause::EpochChanged); ++i)
        EXPECT_EQ(disarmCauseFromName(name(static_cast<Cause>(i))), static_cast<Cause>(i));
    EXPECT_FALSE(armingPhaseFromName("armed already"));
    EXPECT_FALSE(disarmCauseFromName(""));
}

}  // namespace
}  // namespace terratact
