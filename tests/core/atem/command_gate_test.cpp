#include "core/atem/command_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "tests/core/atem/gate_views.h"

namespace terratact {
namespace {

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

TEST(Gate, separatesExploringFromDriving)
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
    EXPECT_EQ(with(ProbeApproval{8, 29.999}), None);
    EXPECT_EQ(with(ProbeApproval{8, 30.0}), ApprovalExpired) << "as in the exploration";
    EXPECT_EQ(with(ProbeApproval{8, -0.001}), ApprovalExpired);
    EXPECT_EQ(with(ProbeApproval{8, kNan}), ApprovalExpired);
    EXPECT_EQ(with(ProbeApproval{.bin = 8}), ApprovalExpired) << "of unknown age";
    EXPECT_EQ(with(ProbeApproval{7, 1.0}), OtherBin);
    EXPECT_EQ(with(ProbeApproval{9, 1.0}), OtherBin);
    EXPECT_EQ(with(ProbeApproval{8, 1.0, ProbeSide::Right}), OtherBin);
}

}  // namespace
}  // namespace terratact
