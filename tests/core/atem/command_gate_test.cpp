#include "core/atem/command_gate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

namespace terratact {
namespace {

using enum GateRefusal;

constexpr GateLimits kLimits;
constexpr std::uint8_t kEpoch = 77;
constexpr std::uint16_t kChallenge = 0xC0DE;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Change = std::function<void(GateView&)>;

/// Armed, halted, everything fresh, no exploration.
GateView ready(RobotActivity activity = RobotActivity::Halted, bool exploring = false)
{
    GateView view;
    view.link = LinkState::Good;
    view.statusAge = 0.05;
    view.answerAge = 0.1;
    view.challenge = kChallenge;
    view.operatorAge = 0.01;
    view.stopLatched = false;
    view.arming = {.phase = ArmingPhase::Armed, .epoch = kEpoch};
    view.robot =
        RobotStatus{.epoch = kEpoch, .activity = activity, .armed = true, .exploring = exploring};
    return view;
}

/// Like ready(), with an approved probe of bin 8.
GateView approved()
{
    GateView view = ready(RobotActivity::Pressed, true);
    view.approval = ProbeApproval{.bin = 8, .age = 2.0};
    return view;
}

/// Before arming: the operator has confirmed, and the robot has not answered yet.
GateView requested()
{
    GateView view = ready();
    view.arming = {.phase = ArmingPhase::Requested};
    view.robot->armed = false;
    return view;
}

GateRefusal verdict(const Command& command, const GateView& view,
                    const GateLimits& limits = kLimits)
{
    return judge(frameOf(command, kEpoch, 1, kChallenge), view, limits);
}

struct Case {
    Command command;
    GateView view;  ///< a view in which it passes
};

/// Every command that needs a state, with a view in which it passes.
std::vector<Case> conditional()
{
    GateView stopped = ready(RobotActivity::Stopped);
    stopped.arming = {};
    stopped.robot->armed = false;
    return {{ReleaseStopCommand{}, stopped},
            {ArmCommand{true}, requested()},
            {DriveCommand{0.2}, ready()},
            {BeginAtemCommand{}, ready()},
            {PressCommand{18.0}, ready(RobotActivity::Halted, true)},
            {HoldFlippersCommand{0.7, -0.2}, ready()},
            {ProbeCommand{8}, approved()},
            {AdvanceCommand{0.1}, ready()}};
}

const std::vector<Command>& safeCommands()
{
    static const std::vector<Command> all{StopCommand{}, HaltCommand{}, AbortAtemCommand{},
                                          ArmCommand{false}};
    return all;
}

TEST(Gate, letsEveryCommandThroughInItsState)
{
    for (const Case& c : conditional())
        EXPECT_EQ(verdict(c.command, c.view), None) << c.command.index();
    std::set<std::size_t> kinds;
    for (const Case& c : conditional()) kinds.insert(c.command.index());
    for (const Command& c : safeCommands()) kinds.insert(c.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a command is missing here";
}

TEST(Gate, defaultViewPassesOnlySafeCommands)
{
    for (const Command& command : safeCommands()) EXPECT_EQ(verdict(command, {}), None);
    for (const Case& c : conditional()) EXPECT_EQ(verdict(c.command, {}), OperatorAbsent);
    EXPECT_EQ(judge(consoleHeartbeat(1, 1), {}, kLimits), OperatorAbsent);
}

TEST(Gate, passesSafeCommandsWhateverIsWrong)
{
    GateView view = ready(RobotActivity::Probing, true);
    view.link = LinkState::Lost;
    view.foreignSender = true;
    view.stopLatched = true;
    view.robot.reset();
    for (const Command& command : safeCommands())
        EXPECT_EQ(judge(frameOf(command, 200, 1), view, kLimits), None) << command.index();
}

TEST(Gate, needsOperatorLinkAndAnswerForOtherCommands)
{
    const std::vector<std::pair<GateRefusal, Change>> wrong{
        {OperatorAbsent, [](GateView& v) { v.operatorAge = 0.1001; }},
        {OperatorAbsent, [](GateView& v) { v.operatorAge = kNan; }},
        {OperatorAbsent, [](GateView& v) { v.operatorAge = -0.001; }},
        {ForeignSender, [](GateView& v) { v.foreignSender = true; }},
        {LinkNotGood, [](GateView& v) { v.robot.reset(); }},
        {LinkNotGood, [](GateView& v) { v.statusAge = 0.1501; }},
        {LinkNotGood, [](GateView& v) { v.statusAge = kNan; }},
        {LinkNotGood, [](GateView& v) { v.statusAge = -1.0; }},
        {LinkNotGood, [](GateView& v) { v.link = LinkState::Unknown; }},
        {LinkNotGood, [](GateView& v) { v.link = LinkState::Starting; }},
        {LinkNotGood, [](GateView& v) { v.link = LinkState::Bad; }},
        {LinkNotGood, [](GateView& v) { v.link = LinkState::Stale; }},
        {LinkNotGood, [](GateView& v) { v.link = LinkState::Lost; }},
        {NotAnswered, [](GateView& v) { v.answerAge = 0.2501; }},
        {NotAnswered, [](GateView& v) { v.answerAge = kNan; }},
        {NotAnswered, [](GateView& v) { v.answerAge = GateView::kNever; }},
        {NotAnswered, [](GateView& v) { v.challenge = 0; }},
        {NotAnswered, [](GateView& v) { v.challenge = kChallenge + 1; }},
        {WrongEpoch, [](GateView& v) { v.robot->epoch = kEpoch + 1; }},
        {StopLatched, [](GateView& v) { v.stopLatched = true; }},
    };
    for (const Case& c : conditional())
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            GateView view = c.view;
            wrong[i].second(view);
            // HoldFlippers carries no epoch: the arming has one.
            const bool hold = std::holds_alternative<HoldFlippersCommand>(c.command);
            const GateRefusal expected =
                hold && wrong[i].first == WrongEpoch ? NotArmed : wrong[i].first;
            EXPECT_EQ(verdict(c.command, view), expected) << c.command.index() << " " << i;
        }
}

TEST(Gate, acceptsAgesUpToTheirLimits)
{
    for (const Case& c : conditional()) {
        GateView view = c.view;
        view.operatorAge = kLimits.operatorAge;
        view.statusAge = kLimits.statusAge;
        view.answerAge = kLimits.answerAge;
        EXPECT_EQ(verdict(c.command, view), None) << c.command.index();
        view.operatorAge = view.statusAge = view.answerAge = 0.0;
        EXPECT_EQ(verdict(c.command, view), None) << c.command.index();
    }
}

TEST(Gate, needsBothEndsArmedInTheSameEpochForMotion)
{
    const std::vector<Change> wrong{
        [](GateView& v) { v.arming = {}; },
        [](GateView& v) { v.arming.phase = ArmingPhase::Confirming; },
        [](GateView& v) { v.arming.phase = ArmingPhase::Requested; },
        [](GateView& v) { v.arming.epoch = kEpoch - 1; },
        [](GateView& v) { v.robot->armed = false; },
    };
    for (const Case& c : conditional()) {
        if (std::holds_alternative<ReleaseStopCommand>(c.command)) continue;
        if (std::holds_alternative<ArmCommand>(c.command)) continue;
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            GateView view = c.view;
            wrong[i](view);
            EXPECT_EQ(verdict(c.command, view), NotArmed) << c.command.index() << " " << i;
        }
    }
}

TEST(Gate, asksForTheRightActivityOfTheRobot)
{
    using enum RobotActivity;
    // Halted, Driving, Pressing, Pressed, Probing, Stopped
    const std::vector<std::pair<Case, std::vector<GateRefusal>>> table{
        {conditional()[0], {NotStopped, NotStopped, NotStopped, NotStopped, NotStopped, None}},
        {conditional()[1], {None, Busy, Busy, None, Busy, StopLatched}},
        {conditional()[2], {None, None, Busy, None, Busy, StopLatched}},
        {conditional()[3], {None, None, Busy, None, Busy, StopLatched}},
        {conditional()[4], {None, Busy, Busy, None, Busy, StopLatched}},
        {conditional()[5], {None, Busy, Busy, None, Busy, StopLatched}},
        {conditional()[6], {NotPressed, NotPressed, NotPressed, None, NotPressed, StopLatched}},
        {conditional()[7], {None, Busy, Busy, None, Busy, StopLatched}},
    };
    for (const auto& [c, expected] : table)
        for (const RobotActivity activity :
             {Halted, Driving, Pressing, Pressed, Probing, Stopped}) {
            GateView view = c.view;
            view.robot->activity = activity;
            EXPECT_EQ(verdict(c.command, view), expected[static_cast<std::size_t>(activity)])
                << c.command.index() << ", " << describe(activity).english;
        }
}

TEST(Gate, keepsExploringAndDrivingApart)
{
    for (const Case& c : conditional()) {
        GateView view = c.view;
        view.robot->exploring = !view.robot->exploring;
        const bool indifferent = std::holds_alternative<ReleaseStopCommand>(c.command)
                              || std::holds_alternative<ArmCommand>(c.command)
                              || std::holds_alternative<HoldFlippersCommand>(c.command);
        const GateRefusal expected = indifferent             ? None
                                   : c.view.robot->exploring ? NotExploring
                                                             : Exploring;
        EXPECT_EQ(verdict(c.command, view), expected) << c.command.index();
    }
}

TEST(Gate, refusesChallengeZeroThoughTheFrameHasItToo)
{
    for (const Case& c : conditional()) {
        GateView view = c.view;
        view.challenge = 0;
        EXPECT_EQ(judge(frameOf(c.command, kEpoch, 1, 0), view, kLimits), NotAnswered)
            << c.command.index();
    }
}

TEST(Gate, armsOnlyWhatTheOperatorHasConfirmed)
{
    GateView view = requested();
    for (const ArmingPhase phase :
         {ArmingPhase::Disarmed, ArmingPhase::Confirming, ArmingPhase::Armed}) {
        view.arming.phase = phase;
        EXPECT_EQ(verdict(ArmCommand{true}, view), NotConfirmed);
        EXPECT_EQ(verdict(ArmCommand{false}, view), None);
    }
}

TEST(Gate, probesOnlyTheRecentlyApprovedBin)
{
    const auto with = [](std::optional<ProbeApproval> approval) {
        GateView view = approved();
        view.approval = approval;
        return verdict(ProbeCommand{8}, view);
    };
    EXPECT_EQ(with(std::nullopt), NotApproved);
    EXPECT_EQ(with(ProbeApproval{8, 0.0}), None);
    EXPECT_EQ(with(ProbeApproval{8, 30.0}), None);
    EXPECT_EQ(with(ProbeApproval{8, 30.001}), ApprovalExpired);
    EXPECT_EQ(with(ProbeApproval{8, -0.001}), ApprovalExpired);
    EXPECT_EQ(with(ProbeApproval{8, kNan}), ApprovalExpired);
    EXPECT_EQ(with(ProbeApproval{.bin = 8}), ApprovalExpired) << "of unknown age";
    EXPECT_EQ(with(ProbeApproval{7, 1.0}), OtherBin);
    EXPECT_EQ(with(ProbeApproval{9, 1.0}), OtherBin);
}

struct Limited {
    std::function<Command(double)> command;
    GateView view;
    double limit, step;  ///< both positive; step: one raw number
    std::function<void(GateLimits&, double)> set;
    double sign = 1.0;
};

TEST(Gate, keepsEveryValueWithinItsLimitToOneRawStep)
{
    const std::vector<Limited> all{
        {[](double v) { return DriveCommand{v}; }, ready(), 0.3, 1e-4,
         [](GateLimits& l, double v) { l.speed = v; }},
        {[](double v) { return DriveCommand{v}; }, ready(), 0.3, 1e-4,
         [](GateLimits& l, double v) { l.speed = v; }, -1.0},
        {[](double v) { return PressCommand{v}; }, ready(RobotActivity::Halted, true), 20.0, 0.01,
         [](GateLimits& l, double v) { l.torque = v; }},
        {[](double v) { return AdvanceCommand{v}; }, ready(), 0.05, 1e-4,
         [](GateLimits& l, double v) { l.advance = v; }},
        {[](double v) {
             return HoldFlippersCommand{v, 0.0};
         },
         ready(), 1.0, 2e-3, [](GateLimits& l, double v) { l.highestFlipper = v; }},
        {[](double v) {
             return HoldFlippersCommand{0.0, v};
         },
         ready(), 1.0, 2e-3, [](GateLimits& l, double v) { l.highestFlipper = v; }},
        {[](double v) {
             return HoldFlippersCommand{v, 0.0};
         },
         ready(), 0.5, 2e-3, [](GateLimits& l, double v) { l.lowestFlipper = -v; }, -1.0},
        {[](double v) {
             return HoldFlippersCommand{0.0, v};
         },
         ready(), 0.5, 2e-3, [](GateLimits& l, double v) { l.lowestFlipper = -v; }, -1.0},
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Limited& c = all[i];
        GateLimits limits;
        c.set(limits, c.limit);
        EXPECT_EQ(verdict(c.command(c.sign * c.limit), c.view, limits), None) << i;
        EXPECT_EQ(verdict(c.command(c.sign * (c.limit + c.step)), c.view, limits), OverLimit) << i;
        c.set(limits, kNan);
        EXPECT_EQ(verdict(c.command(c.sign * c.limit), c.view, limits), OverLimit) << i;
    }
}

TEST(Gate, defaultLimitsCoverExactlyTheDbcRanges)
{
    EXPECT_EQ(verdict(DriveCommand{0.6}, ready()), None);
    EXPECT_EQ(verdict(DriveCommand{-0.6}, ready()), None);
    EXPECT_EQ(verdict(AdvanceCommand{0.1}, ready()), None);
    EXPECT_EQ(verdict(PressCommand{60.0}, ready(RobotActivity::Pressed, true)), None);
    EXPECT_EQ(verdict(AdvanceCommand{0.001}, ready()), None);
    EXPECT_EQ(verdict(PressCommand{0.01}, ready(RobotActivity::Pressed, true)), None);
    EXPECT_EQ(verdict(HoldFlippersCommand{3.14, -1.6}, ready()), None);
    EXPECT_EQ(verdict(HoldFlippersCommand{-1.602, 0.0}, ready()), OverLimit);
    // The codec refuses 0.1001 m, so this frame is built by hand.
    CanFrame frame = frameOf(AdvanceCommand{0.1}, kEpoch, 1, kChallenge);
    frame.data[4] = 1001 & 0xFF;
    frame.data[5] = 1001 >> 8;
    protect(std::span(frame.data).first(8), 1, layoutOf(FrameKind::Advance).dataId);
    GateLimits wide;
    wide.advance = 100.0;
    EXPECT_EQ(judge(frame, ready(), wide), Malformed);
}

TEST(Gate, sweepsEveryRawSpeed)
{
    GateLimits limits;
    limits.speed = 0.2;
    int passed = 0;
    for (int raw = -32768; raw <= 32767; ++raw) {
        CanFrame frame = frameOf(DriveCommand{0.0}, kEpoch, 1, kChallenge);
        frame.data[4] = static_cast<std::uint8_t>(raw & 0xFF);
        frame.data[5] = static_cast<std::uint8_t>((raw >> 8) & 0xFF);
        protect(std::span(frame.data).first(8), 1, layoutOf(FrameKind::Drive).dataId);
        const GateRefusal refusal = judge(frame, ready(), limits);
        const int size = std::abs(raw);
        ASSERT_EQ(refusal, size <= 2000 ? None : size <= 6000 ? OverLimit : Malformed) << raw;
        passed += refusal == None;
    }
    EXPECT_EQ(passed, 4001);
}

TEST(Gate, heartbeatNeedsOnlyTheOperator)
{
    GateView view;
    const CanFrame heartbeat = consoleHeartbeat(4711, 1);
    view.operatorAge = kLimits.operatorAge;
    EXPECT_EQ(judge(heartbeat, view, kLimits), None);
    view.operatorAge = kLimits.operatorAge + 1e-6;
    EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
}

TEST(Gate, heartbeatsMayPauseASecondWhileNothingMoves)
{
    const CanFrame heartbeat = consoleHeartbeat(4711, 1);
    GateView view;
    view.moves = false;
    view.operatorAge = kLimits.operatorPause;
    EXPECT_EQ(judge(heartbeat, view, kLimits), None);
    view.operatorAge = kLimits.operatorPause + 1e-6;
    EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
    for (const double bad : {kNan, -0.001}) {
        view.operatorAge = bad;
        EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
    }
    // Only the heartbeat passes: motion needs a recent answer.
    for (const Case& c : conditional()) {
        GateView paused = approved();
        paused.moves = false;
        paused.operatorAge = 0.3;
        EXPECT_EQ(verdict(c.command, paused), OperatorAbsent);
    }
}

TEST(Gate, neverSendsAFrameOfTheRobot)
{
    for (const CanFrame& frame : {frameOf(RobotStatus{}, 0), robotHeartbeat(1, 0)})
        EXPECT_EQ(judge(frame, approved(), kLimits), NotAllowed);
    for (const CanFrame& frame : framesOf(SensorLine{}, 0))
        EXPECT_EQ(judge(frame, approved(), kLimits), NotAllowed);
}

/// Every state of arming, robot and operator, some hundreds of views.
std::vector<GateView> manyViews()
{
    std::vector<GateView> views{GateView{}};
    for (const auto phase : {ArmingPhase::Disarmed, ArmingPhase::Confirming, ArmingPhase::Requested,
                             ArmingPhase::Armed})
        for (int activity = 0; activity <= static_cast<int>(RobotActivity::Stopped); ++activity)
            for (const bool exploring : {false, true})
                for (const bool stop : {false, true}) {
                    GateView view = ready(static_cast<RobotActivity>(activity), exploring);
                    view.arming.phase = phase;
                    view.stopLatched = stop;
                    view.approval = ProbeApproval{8, 1.0};
                    views.push_back(view);
                }
    return views;
}

TEST(Gate, leaksNoFrameOfAnyIdLengthFlagAndState)
{
    std::uint64_t leaks = 0;
    // Frames that are valid except for identifier, length or flags.
    const CanFrame sound = frameOf(StopCommand{}, 0, 1);
    for (const GateView& view : manyViews())
        for (std::uint32_t id = 0; id < 2048; ++id)
            for (std::uint8_t length = 0; length <= 8; ++length) {
                if (id == sound.id && length == 8) continue;
                CanFrame frame = sound;
                frame.id = id;
                frame.length = length;
                leaks += judge(frame, view, kLimits) == None;
            }
    EXPECT_EQ(leaks, 0U);
}

TEST(Gate, leaksNoFlaggedFrameAndNoExtendedIdentifier)
{
    std::mt19937 rng(3);
    std::uint64_t leaks = 0;
    std::vector<CanFrame> frames;
    for (const Case& c : conditional()) frames.push_back(frameOf(c.command, kEpoch, 1, kChallenge));
    for (const Command& c : safeCommands()) frames.push_back(frameOf(c, kEpoch, 1));
    for (const CanFrame& frame : frames)
        for (unsigned flags = 1; flags < 16; ++flags) {
            CanFrame flagged = frame;
            flagged.extended = (flags & 1U) != 0;
            flagged.remote = (flags & 2U) != 0;
            flagged.error = (flags & 4U) != 0;
            flagged.fd = (flags & 8U) != 0;
            for (const GateView& view : manyViews()) leaks += judge(flagged, view, kLimits) == None;
        }
    for (int i = 0; i < 1'000'000; ++i) {
        CanFrame frame = frames[static_cast<std::size_t>(i) % frames.size()];
        frame.id = static_cast<std::uint32_t>(rng()) & 0x1FFFFFFFU;
        frame.extended = true;
        leaks += judge(frame, ready(), kLimits) == None;
    }
    EXPECT_EQ(leaks, 0U);
}

TEST(Gate, tellsADamagedFrameFromAForeignOne)
{
    CanFrame frame = frameOf(StopCommand{}, 0, 1);
    frame.data[7] ^= 1U;
    EXPECT_EQ(judge(frame, ready(), kLimits), Malformed);
    frame.length = 7;
    EXPECT_EQ(judge(frame, ready(), kLimits), Malformed);
    frame.remote = true;
    EXPECT_EQ(judge(frame, ready(), kLimits), NotAllowed);
    EXPECT_EQ(judge({.id = 0x123, .length = 8}, ready(), kLimits), NotAllowed);
}

TEST(Gate, hasWordsForEveryRefusal)
{
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(OtherBin); ++i)
        words.insert(describe(static_cast<GateRefusal>(i)).english);
    EXPECT_EQ(words.size(), static_cast<std::size_t>(OtherBin) + 1);
    EXPECT_FALSE(words.contains(""));
    EXPECT_THROW(static_cast<void>(describe(static_cast<GateRefusal>(99)).english),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
