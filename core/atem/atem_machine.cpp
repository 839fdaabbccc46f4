#include "core/atem/atem_machine.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/message.h"
#include "core/base/named.h"

namespace terratact {
namespace {

/// Returns true if the scene of the exploration is captured, so that the robot must not move.
bool sceneCaptured(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Estimating:
    case AtemPhase::ProposingProbe:
    case AtemPhase::Probing:
    case AtemPhase::EstimatingAgain: return true;
    case AtemPhase::Idle:
    case AtemPhase::Halting:
    case AtemPhase::Pressing:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed:
    case AtemPhase::Advancing: return false;
    }
    return false;
}

/// Returns true if an exploration may move the robot in this phase without another question.
bool movesByItself(AtemPhase phase)
{
    return phase == AtemPhase::Halting || phase == AtemPhase::Pressing
        || phase == AtemPhase::Advancing;
}

/// Returns the state without the loop, which ended for this reason.
AtemState withoutLoop(AtemState state, LoopEnd end)
{
    if (!state.loops) return state;
    state.loops = false;
    state.loopEnd = end;
    return state;
}

/// Returns true if the approval was given for the present grounds.
bool fits(const AtemInput& in)
{
    return !in.grounds.empty() && in.approvedFor == in.grounds;
}

/// The states that one tick can lead to.
struct Tick {
    const AtemState& now;
    const AtemInput& in;
    const AtemLimits& limits;

    bool loopBegins() const { return in.loopRequested && in.held; }
    bool requested() const { return in.requested || loopBegins(); }
    bool late() const
    {
        const std::optional<double> end = deadline(now, limits);
        return end && in.now >= *end;
    }

    /// Goes on with the exploration.
    AtemState enter(AtemPhase phase) const
    {
        AtemState next = begin(phase);
        next.probed = now.probed;
        next.approvalExpired = now.approvalExpired;
        return next;
    }
    /// Forgets the exploration.
    AtemState begin(AtemPhase phase) const
    {
        return {.phase = phase, .since = in.now, .loops = now.loops, .loopEnd = now.loopEnd};
    }
    AtemState fail(AtemFailure failure) const
    {
        AtemState next = withoutLoop(enter(AtemPhase::Failed), LoopEnd::Fault);
        next.failure = failure;
        return next;
    }
    AtemState endLoop(LoopEnd why) const { return withoutLoop(begin(AtemPhase::Idle), why); }

    AtemState request() const
    {
        AtemState next = begin(AtemPhase::Halting);
        next.loops = !in.requested && loopBegins();
        next.loopEnd = LoopEnd::None;
        if (in.linkAlive && in.armed) return next;
        next.phase = AtemPhase::Failed;
        next.failure = in.linkAlive ? AtemFailure::Disarmed : AtemFailure::LinkLost;
        return withoutLoop(next, LoopEnd::Fault);
    }
    /// The loop goes on from its result, or begins at one.
    AtemState goOn() const
    {
        const bool stands = in.linkAlive && in.armed && !in.poseChanged;
        if (stands && in.forbids == LoopEnd::None) {
            AtemState next = begin(AtemPhase::Advancing);
            next.loops = true;
            next.loopEnd = LoopEnd::None;
            return next;
        }
        if (loopBegins()) return request();  // this result does not serve: press again
        if (!in.linkAlive) return fail(AtemFailure::LinkLost);
        if (!in.armed) return fail(AtemFailure::Disarmed);
        return in.poseChanged ? fail(AtemFailure::PoseChanged) : withoutLoop(now, in.forbids);
    }
    AtemState estimated() const
    {
        if (!in.probeWanted) return enter(AtemPhase::Presenting);
        return withoutLoop(enter(AtemPhase::ProposingProbe), LoopEnd::ProbeProposed);
    }
    AtemState answered() const
    {
        if (in.refused) return enter(AtemPhase::Presenting);
        if (late() || (in.approved && !isApprovalValid(in.approvalAge, limits.approval))) {
            AtemState next = enter(AtemPhase::Presenting);
            next.approvalExpired = true;
            return next;
        }
        if (!in.approved) return now;
        return fits(in) ? enter(AtemPhase::Probing) : fail(AtemFailure::ApprovalVoid);
    }
    AtemState probed() const
    {
        AtemState next = enter(AtemPhase::EstimatingAgain);
        next.probed = true;
        return next;
    }
    AtemState advance() const
    {
        if (!in.telemetryFresh) return fail(AtemFailure::LinkLost);
        if (in.advanceRefused) return fail(AtemFailure::AdvanceRefused);
        if (in.ranOn) return fail(AtemFailure::RanOn);
        if (in.notMoved) return fail(AtemFailure::NotMoved);
        if (in.requested) return endLoop(LoopEnd::Aborted);
        if (in.tilted) return endLoop(LoopEnd::Attitude);
        if (in.noOdometry) return endLoop(LoopEnd::NoOdometry);
        if (in.advanced) return begin(AtemPhase::Halting);
        return late() ? fail(AtemFailure::AdvanceTimeout) : now;
    }
};

}  // namespace

AtemState nextState(const AtemState& now, const AtemInput& in, const AtemLimits& limits)
{
    if (!std::isfinite(in.now)) throw std::invalid_argument("nextState: the time must be finite");
    const Tick tick{now, in, limits};
    const auto orLate = [&](AtemFailure failure) { return tick.late() ? tick.fail(failure) : now; };

    if (in.stop)
        return now.phase == AtemPhase::Stopped
                 ? now
                 : withoutLoop(tick.enter(AtemPhase::Stopped), LoopEnd::Stop);
    if (in.aborted && now.phase != AtemPhase::Stopped)
        return now.phase == AtemPhase::Idle ? now : tick.endLoop(LoopEnd::Aborted);
    if (now.loops && !in.held)
        return movesByItself(now.phase) ? tick.endLoop(LoopEnd::LetGo)
                                        : nextState(withoutLoop(now, LoopEnd::LetGo), in, limits);
    if (exploring(now.phase) && !in.linkAlive) return tick.fail(AtemFailure::LinkLost);
    if (exploring(now.phase) && !in.armed) return tick.fail(AtemFailure::Disarmed);
    if (exploring(now.phase) && in.notSent) return tick.fail(AtemFailure::NotSent);
    if (sceneCaptured(now.phase) && in.poseChanged) return tick.fail(AtemFailure::PoseChanged);

    switch (now.phase) {
    case AtemPhase::Idle: return tick.requested() ? tick.request() : now;
    case AtemPhase::Halting:
        if (in.halted) return tick.enter(AtemPhase::Pressing);
        return orLate(in.unbegun ? AtemFailure::BeginTimeout : AtemFailure::HaltTimeout);
    case AtemPhase::Pressing:
        if (in.pressRefused) return tick.fail(AtemFailure::PressRefused);
        return in.pressed ? tick.enter(AtemPhase::Estimating) : orLate(AtemFailure::PressTimeout);
    case AtemPhase::Estimating:
        if (in.estimateFailed) return tick.fail(AtemFailure::EstimateError);
        return in.estimateReady ? tick.estimated() : orLate(AtemFailure::EstimateTimeout);
    case AtemPhase::ProposingProbe: return tick.answered();
    case AtemPhase::Probing:
        if (in.probeRefused) return tick.fail(AtemFailure::ProbeRefused);
        return in.probeDone ? tick.probed() : orLate(AtemFailure::ProbeTimeout);
    case AtemPhase::EstimatingAgain:
        if (in.estimateFailed) return tick.fail(AtemFailure::EstimateError);
        return in.estimateReady ? tick.enter(AtemPhase::Presenting)
                                : orLate(AtemFailure::EstimateTimeout);
    case AtemPhase::Presenting:
        if (in.requested) return tick.request();
        if (now.loops || tick.loopBegins()) return tick.goOn();
        return in.poseChanged ? tick.begin(AtemPhase::Idle) : now;
    case AtemPhase::Stopped: return in.stopReleased ? tick.begin(AtemPhase::Idle) : now;
    case AtemPhase::Failed: return tick.requested() ? tick.request() : now;
    case AtemPhase::Advancing: return tick.advance();
    }
    throw std::invalid_argument("nextState: no such phase");
}

std::optional<double> deadline(const AtemState& state, const AtemLimits& limits)
{
    const bool computes =
        state.phase == AtemPhase::Estimating || state.phase == AtemPhase::EstimatingAgain;
    if (state.followed && !computes) return std::nullopt;  // no phase waits for the robot
    switch (state.phase) {
    case AtemPhase::Halting: return state.since + limits.halt;
    case AtemPhase::Pressing: return state.since + limits.press;
    case AtemPhase::Estimating:
    case AtemPhase::EstimatingAgain: return state.since + limits.estimate;
    case AtemPhase::ProposingProbe: return state.since + limits.approval;
    case AtemPhase::Probing: return state.since + limits.probe;
    case AtemPhase::Advancing: return state.since + limits.advance;
    case AtemPhase::Idle:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: return std::nullopt;
    }
    return std::nullopt;
}

bool exploring(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Halting:
    case AtemPhase::Pressing:
    case AtemPhase::Estimating:
    case AtemPhase::ProposingProbe:
    case AtemPhase::Probing:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Advancing: return true;
    case AtemPhase::Idle:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: return false;
    }
    return false;
}

SourceText describe(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Idle: return TR_NOOP("core", "ready");
    case AtemPhase::Halting: return TR_NOOP("core", "halting the robot");
    case AtemPhase::Pressing: return TR_NOOP("core", "pressing the front flippers down");
    case AtemPhase::Estimating: return TR_NOOP("core", "estimating the terrain");
    case AtemPhase::ProposingProbe: return TR_NOOP("core", "arm probe proposed");
    case AtemPhase::Probing: return TR_NOOP("core", "arm is probing");
    case AtemPhase::EstimatingAgain:
        return TR_NOOP("core", "estimating again with the arm's height");
    case AtemPhase::Presenting: return TR_NOOP("core", "estimate stands");
    case AtemPhase::Stopped: return TR_NOOP("core", "STOPPED");
    case AtemPhase::Failed: return TR_NOOP("core", "exploration failed");
    case AtemPhase::Advancing: return TR_NOOP("core", "advancing");
    }
    throw std::invalid_argument("describe: no such AtemPhase");
}

SourceText describe(AtemFailure failure)
{
    switch (failure) {
    case AtemFailure::None: return TR_NOOP("core", "no failure");
    case AtemFailure::HaltTimeout: return TR_NOOP("core", "the robot did not halt in time");
    case AtemFailure::PressTimeout:
        return TR_NOOP("core", "the flippers found nothing to press against in time");
    case AtemFailure::EstimateTimeout: return TR_NOOP("core", "the estimate took too long");
    case AtemFailure::EstimateError: return TR_NOOP("core", "the estimate could not be computed");
    case AtemFailure::ProbeTimeout: return TR_NOOP("core", "the arm did not finish in time");
    case AtemFailure::ProbeRefused: return TR_NOOP("core", "the robot refused the probe");
    case AtemFailure::PressRefused: return TR_NOOP("core", "the robot refused to press");
    case AtemFailure::LinkLost: return TR_NOOP("core", "the link to the robot was lost");
    case AtemFailure::PoseChanged:
        return TR_NOOP("core", "the robot moved, so what it felt no longer holds");
    case AtemFailure::ApprovalVoid:
        return TR_NOOP("core", "the approval was of another scene, settings or model");
    case AtemFailure::Disarmed: return TR_NOOP("core", "the robot is not armed");
    case AtemFailure::AdvanceTimeout:
        return TR_NOOP("core", "the robot did not finish the advance in time");
    case AtemFailure::AdvanceRefused: return TR_NOOP("core", "the advance was refused");
    case AtemFailure::NotMoved:
        return TR_NOOP("core", "the tracks moved less than the commanded advance");
    case AtemFailure::RanOn:
        return TR_NOOP("core", "the tracks moved further than the commanded advance");
    case AtemFailure::NotSent: return TR_NOOP("core", "a command could not be sent");
    case AtemFailure::BeginTimeout:
        return TR_NOOP("core", "the robot did not begin the exploration in time");
    }
    throw std::invalid_argument("describe: no such AtemFailure");
}

namespace {

constexpr auto kPhaseNames =
    namesOf<AtemPhase>("idle", "halting", "pressing", "estimating", "proposing-probe", "probing",
                       "estimating-again", "presenting", "stopped", "failed", "advancing");

constexpr auto kFailureNames = namesOf<AtemFailure>(
    "none", "halt-timeout", "press-timeout", "estimate-timeout", "estimate-error", "probe-timeout",
    "probe-refused", "press-refused", "link-lost", "pose-changed", "approval-void", "disarmed",
    "advance-timeout", "advance-refused", "not-moved", "ran-on", "not-sent", "begin-timeout");

}  // namespace

std::string_view name(AtemPhase phase)
{
    return nameIn(kPhaseNames, phase);
}

std::optional<AtemPhase> atemPhaseFromName(std::string_view text)
{
    return valueIn<AtemPhase>(kPhaseNames, text);
}

std::string_view name(AtemFailure failure)
{
    return nameIn(kFailureNames, failure);
}

std::optional<AtemFailure> atemFailureFromName(std::string_view text)
{
    return valueIn<AtemFailure>(kFailureNames, text);
}

}  // namespace terratact
