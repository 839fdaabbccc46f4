#include "core/atem/arming.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/message.h"
#include "core/base/named.h"

namespace terratact {
namespace {

ArmingState disarmed(DisarmCause cause, double now)
{
    return {.phase = ArmingPhase::Disarmed, .cause = cause, .since = now, .epoch = 0};
}

ArmingState entered(ArmingPhase phase, double now, std::uint8_t epoch = 0)
{
    return {.phase = phase, .cause = DisarmCause::None, .since = now, .epoch = epoch};
}

// Returns the fault that forbids every phase but Disarmed.
DisarmCause fault(const ArmingInput& in)
{
    if (in.stopLatched) return DisarmCause::Stop;
    if (in.disarmed) return DisarmCause::Operator;
    if (!in.operatorPresent) return DisarmCause::OperatorAbsent;
    if (in.foreignSender) return DisarmCause::ForeignSender;
    if (!(in.linkGoodFor > 0.0)) return DisarmCause::LinkNotGood;
    return DisarmCause::None;
}

bool late(const ArmingState& state, const ArmingInput& in, double limit)
{
    return !(in.now - state.since < limit);
}

ArmingState whenDisarmed(const ArmingState& state, const ArmingInput& in,
                         const ArmingLimits& limits)
{
    if (!in.wanted) return state;
    if (const DisarmCause cause = fault(in); cause != DisarmCause::None)
        return disarmed(cause, in.now);
    if (!(in.linkGoodFor >= limits.linkGood)) return disarmed(DisarmCause::LinkNotGood, in.now);
    if (in.robotArmed) return disarmed(DisarmCause::AlreadyArmed, in.now);
    return entered(ArmingPhase::Confirming, in.now);
}

ArmingState whenConfirming(const ArmingState& state, const ArmingInput& in,
                           const ArmingLimits& limits)
{
    if (in.robotArmed) return disarmed(DisarmCause::AlreadyArmed, in.now);
    if (late(state, in, limits.confirm)) return disarmed(DisarmCause::ConfirmTimeout, in.now);
    return in.confirmed ? entered(ArmingPhase::Requested, in.now) : state;
}

ArmingState whenRequested(const ArmingState& state, const ArmingInput& in,
                          const ArmingLimits& limits)
{
    if (in.robotArmed && in.robotEpoch != 0)
        return entered(ArmingPhase::Armed, in.now, in.robotEpoch);
    return late(state, in, limits.request) ? disarmed(DisarmCause::RequestTimeout, in.now) : state;
}

ArmingState whenArmed(const ArmingState& state, const ArmingInput& in)
{
    if (!in.robotArmed) return disarmed(DisarmCause::RobotDisarmed, in.now);
    return in.robotEpoch == state.epoch ? state : disarmed(DisarmCause::EpochChanged, in.now);
}

}  // namespace

ArmingState nextArming(const ArmingState& state, const ArmingInput& in, const ArmingLimits& limits)
{
    if (!std::isfinite(in.now)) throw std::invalid_argument("nextArming: the time must be finite");
    const DisarmCause cause = fault(in);
    if (state.phase != ArmingPhase::Disarmed && cause != DisarmCause::None)
        return disarmed(cause, in.now);
    switch (state.phase) {
    case ArmingPhase::Disarmed: return whenDisarmed(state, in, limits);
    case ArmingPhase::Confirming: return whenConfirming(state, in, limits);
    case ArmingPhase::Requested: return whenRequested(state, in, limits);
    case ArmingPhase::Armed: return whenArmed(state, in);
    }
    throw std::invalid_argument("nextArming: no such phase");
}

SourceText describe(ArmingPhase phase)
{
    switch (phase) {
    case ArmingPhase::Disarmed: return TR_NOOP("event", "disarmed");
    case ArmingPhase::Confirming: return TR_NOOP("event", "confirm to arm");
    case ArmingPhase::Requested: return TR_NOOP("event", "waiting for the robot to arm");
    case ArmingPhase::Armed: return TR_NOOP("event", "armed");
    }
    throw std::invalid_argument("describe: no such ArmingPhase");
}

SourceText describe(DisarmCause cause)
{
    switch (cause) {
    case DisarmCause::None: return TR_NOOP("core", "not armed yet");
    case DisarmCause::Operator: return TR_NOOP("core", "disarmed by the operator");
    case DisarmCause::Stop: return TR_NOOP("core", "STOP is latched");
    case DisarmCause::OperatorAbsent: return TR_NOOP("core", "window or panel does not answer");
    case DisarmCause::ForeignSender:
        return TR_NOOP("core", "somebody else sends this console's frames");
    case DisarmCause::LinkNotGood: return TR_NOOP("core", "the link is not good");
    case DisarmCause::AlreadyArmed:
        return TR_NOOP("core", "the robot is armed, but not by this console");
    case DisarmCause::ConfirmTimeout: return TR_NOOP("core", "not confirmed in time");
    case DisarmCause::RequestTimeout: return TR_NOOP("core", "the robot did not arm in time");
    case DisarmCause::RobotDisarmed: return TR_NOOP("core", "the robot has disarmed");
    case DisarmCause::EpochChanged: return TR_NOOP("core", "the robot has begun anew");
    }
    throw std::invalid_argument("describe: no such DisarmCause");
}

namespace {

constexpr auto kArmingNames = namesOf<ArmingPhase>("disarmed", "confirming", "requested", "armed");

constexpr auto kCauseNames = namesOf<DisarmCause>(
    "none", "operator", "stop", "operator-absent", "foreign-sender", "link-not-good",
    "already-armed", "confirm-timeout", "request-timeout", "robot-disarmed", "epoch-changed");

}  // namespace

std::string_view name(ArmingPhase phase)
{
    return nameIn(kArmingNames, phase);
}

std::optional<ArmingPhase> armingPhaseFromName(std::string_view text)
{
    return valueIn<ArmingPhase>(kArmingNames, text);
}

std::string_view name(DisarmCause cause)
{
    return nameIn(kCauseNames, cause);
}

std::optional<DisarmCause> disarmCauseFromName(std::string_view text)
{
    return valueIn<DisarmCause>(kCauseNames, text);
}

}  // namespace terratact
