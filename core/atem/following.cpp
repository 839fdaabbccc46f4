#include "core/atem/following.h"

#include <cmath>
#include <stdexcept>

#include "core/base/message.h"

namespace terratact {
namespace {

/// Returns true if something on the screen depends on the robot's readings.
bool restsOnTheRobot(AtemPhase phase)
{
    return exploring(phase) || phase == AtemPhase::Presenting;
}

AtemState enter(AtemPhase phase, const FollowInput& in, bool probed)
{
    return {.phase = phase, .since = in.now, .probed = probed, .followed = true};
}

AtemState begin(AtemPhase phase, const FollowInput& in)
{
    return enter(phase, in, false);
}

AtemState fail(AtemFailure failure, const FollowInput& in)
{
    AtemState next = begin(AtemPhase::Failed, in);
    next.failure = failure;
    return next;
}

AtemState whenEstimating(const AtemState& now, const FollowInput& in, const AtemLimits& limits)
{
    if (in.estimateFailed) return fail(AtemFailure::EstimateError, in);
    if (in.estimateReady) return enter(AtemPhase::Presenting, in, now.probed);
    const std::optional<double> end = deadline(now, limits);
    return end && in.now >= *end ? fail(AtemFailure::EstimateTimeout, in) : now;
}

AtemState whenPresenting(const AtemState& now, const FollowInput& in)
{
    if (in.newReading) return enter(AtemPhase::EstimatingAgain, in, true);
    const bool probing = in.activity == RobotActivity::Probing;
    if (probing == (now.phase == AtemPhase::Probing)) return now;
    return enter(probing ? AtemPhase::Probing : AtemPhase::Presenting, in, now.probed);
}

}  // namespace

AtemState nextFollowed(const AtemState& now, const FollowInput& in, const AtemLimits& limits)
{
    if (!std::isfinite(in.now))
        throw std::invalid_argument("nextFollowed: the time must be finite");
    if (in.linkLost) return restsOnTheRobot(now.phase) ? fail(AtemFailure::LinkLost, in) : now;
    if (in.activity == RobotActivity::Stopped)
        return now.phase == AtemPhase::Stopped ? now : begin(AtemPhase::Stopped, in);
    if (now.phase == AtemPhase::Stopped) return begin(AtemPhase::Idle, in);
    if (in.aborted && now.phase != AtemPhase::Idle) return begin(AtemPhase::Idle, in);
    if (in.newPress) return begin(AtemPhase::Estimating, in);
    if (in.activity == RobotActivity::Pressing)
        return now.phase == AtemPhase::Pressing ? now : begin(AtemPhase::Pressing, in);
    if (in.poseChanged && restsOnTheRobot(now.phase)) return begin(AtemPhase::Idle, in);

    switch (now.phase) {
    case AtemPhase::Estimating:
    case AtemPhase::EstimatingAgain: return whenEstimating(now, in, limits);
    case AtemPhase::Presenting:
    case AtemPhase::Probing: return whenPresenting(now, in);
    case AtemPhase::Halting:
    case AtemPhase::Pressing:
    case AtemPhase::ProposingProbe:
    case AtemPhase::Advancing: return begin(AtemPhase::Idle, in);
    case AtemPhase::Idle:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: return now;
    }
    throw std::invalid_argument("nextFollowed: no such phase");
}

SourceText describeFollowed(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Idle:
    case AtemPhase::Advancing: return TR_NOOP("core", "following: nothing is explored");
    case AtemPhase::Halting:
    case AtemPhase::Pressing: return TR_NOOP("core", "following: flippers go down");
    case AtemPhase::Estimating:
        return TR_NOOP("core", "following: flippers pressed, estimating the terrain");
    case AtemPhase::Probing: return TR_NOOP("core", "following: flippers pressed, arm is probing");
    case AtemPhase::EstimatingAgain:
        return TR_NOOP("core", "following: estimating again with the arm's height");
    case AtemPhase::ProposingProbe:
    case AtemPhase::Presenting: return TR_NOOP("core", "following: estimate stands");
    case AtemPhase::Stopped: return TR_NOOP("core", "following: the robot is stopped");
    case AtemPhase::Failed: return TR_NOOP("core", "following: no estimate");
    }
    throw std::invalid_argument("describeFollowed: no such phase");
}

}  // namespace terratact
