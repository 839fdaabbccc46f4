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
    case AtemPhase::Failed: return false;
    }
    return false;
}

/// Returns true for an expired approval. A negative age or NaN counts as expired.
bool isStale(double approvalAge, const AtemLimits& limits)
{
    return !(approvalAge >= 0.0 && approvalAge < limits.approval);
}

/// Returns true if the approval was given for the present grounds.
bool fits(const AtemInput& in)
{
    return !in.grounds.empty() && in.approvedFor == in.grounds;
}

}  // namespace

AtemState nextState(const AtemState& now, const AtemInput& in, const AtemLimits& limits)
{
    if (!std::isfinite(in.now)) throw std::invalid_argument("nextState: the time must be finite");

    const auto enter = [&](AtemPhase phase) {
        return AtemState{.phase = phase,
                         .failure = AtemFailure::None,
                         .since = in.now,
                         .probed = now.probed,
                         .approvalExpired = now.approvalExpired};
    };
    const auto fail = [&](AtemFailure failure) {
        AtemState next = enter(AtemPhase::Failed);
        next.failure = failure;
        return next;
    };
    const auto begin = [&](AtemPhase phase) { return AtemState{.phase = phase, .since = in.now}; };
    const auto request = [&] {
        if (!in.linkAlive) return fail(AtemFailure::LinkLost);
        return in.armed ? begin(AtemPhase::Halting) : fail(AtemFailure::Disarmed);
    };

    if (in.stop) return now.phase == AtemPhase::Stopped ? now : enter(AtemPhase::Stopped);
    if (in.aborted && now.phase != AtemPhase::Stopped)
        return now.phase == AtemPhase::Idle ? now : begin(AtemPhase::Idle);
    if (exploring(now.phase) && !in.linkAlive) return fail(AtemFailure::LinkLost);
    if (exploring(now.phase) && !in.armed) return fail(AtemFailure::Disarmed);
    if (sceneCaptured(now.phase) && in.poseChanged) return fail(AtemFailure::PoseChanged);

    const std::optional<double> end = deadline(now, limits);
    const bool late = end && in.now >= *end;

    switch (now.phase) {
    case AtemPhase::Idle: return in.requested ? request() : now;
    case AtemPhase::Halting:
        if (in.halted) return enter(AtemPhase::Pressing);
        return late ? fail(AtemFailure::HaltTimeout) : now;
    case AtemPhase::Pressing:
        if (in.pressRefused) return fail(AtemFailure::PressRefused);
        if (in.pressed) return enter(AtemPhase::Estimating);
        return late ? fail(AtemFailure::PressTimeout) : now;
    case AtemPhase::Estimating:
        if (in.estimateFailed) return fail(AtemFailure::EstimateError);
        if (in.estimateReady)
            return enter(in.probeWanted ? AtemPhase::ProposingProbe : AtemPhase::Presenting);
        return late ? fail(AtemFailure::EstimateTimeout) : now;
    case AtemPhase::ProposingProbe:
        if (in.refused) return enter(AtemPhase::Presenting);
        if (late || (in.approved && isStale(in.approvalAge, limits))) {
            AtemState next = enter(AtemPhase::Presenting);
            next.approvalExpired = true;
            return next;
        }
        if (!in.approved) return now;
        return fits(in) ? enter(AtemPhase::Probing) : fail(AtemFailure::ApprovalVoid);
    case AtemPhase::Probing:
        if (in.probeRefused) return fail(AtemFailure::ProbeRefused);
        if (in.probeDone) {
            AtemState next = enter(AtemPhase::EstimatingAgain);
            next.probed = true;
            return next;
        }
        return late ? fail(AtemFailure::ProbeTimeout) : now;
    case AtemPhase::EstimatingAgain:
        if (in.estimateFailed) return fail(AtemFailure::EstimateError);
        if (in.estimateReady) return enter(AtemPhase::Presenting);
        return late ? fail(AtemFailure::EstimateTimeout) : now;
    case AtemPhase::Presenting:
        if (in.requested) return request();
        return in.poseChanged ? begin(AtemPhase::Idle) : now;
    case AtemPhase::Stopped: return in.stopReleased ? begin(AtemPhase::Idle) : now;
    case AtemPhase::Failed: return in.requested ? request() : now;
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
    case AtemPhase::EstimatingAgain: return true;
    case AtemPhase::Idle:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: return false;
    }
    return false;
}

bool mayDrive(AtemPhase phase)
{
    return !exploring(phase) && phase != AtemPhase::Stopped;
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
    }
    throw std::invalid_argument("describe: no such AtemFailure");
}

namespace {

constexpr auto kPhaseNames =
    namesOf<AtemPhase>("idle", "halting", "pressing", "estimating", "proposing-probe", "probing",
                       "estimating-again", "presenting", "stopped", "failed");

constexpr auto kFailureNames = namesOf<AtemFailure>(
    "none", "halt-timeout", "press-timeout", "estimate-timeout", "estimate-error", "probe-timeout",
    "probe-refused", "press-refused", "link-lost", "pose-changed", "approval-void", "disarmed");

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
