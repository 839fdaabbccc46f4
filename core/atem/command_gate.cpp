#include "core/atem/command_gate.h"

#include <stdexcept>
#include <variant>

#include "core/base/message.h"

namespace terratact {
namespace {

using enum GateRefusal;

// Tolerance of a value that was rounded to its raw number: far below every scale.
constexpr double kSlack = 1e-9;

bool within(double value, double least, double most)
{
    return value >= least - kSlack && value <= most + kSlack;
}

// Returns true for a recent age. A negative age is not recent.
bool isFresh(double age, double limit)
{
    return age >= 0.0 && age <= limit;
}

bool standsStill(RobotActivity activity)
{
    return activity == RobotActivity::Halted || activity == RobotActivity::Pressed;
}

// Judges one command against all conditions. A new command type does not compile without its own
// operator().
struct Judge {
    const GateView& view;
    const GateLimits& limits;
    const ReceivedCommand& frame;

    // Commands that make the robot safer.
    GateRefusal operator()(const StopCommand&) const { return None; }
    GateRefusal operator()(const HaltCommand&) const { return None; }
    GateRefusal operator()(const AbortAtemCommand&) const { return None; }

    GateRefusal operator()(const ReleaseStopCommand&) const
    {
        if (const GateRefusal refusal = linkRefusal(); refusal != None) return refusal;
        if (view.stopLatched) return StopLatched;
        return view.robot->activity == RobotActivity::Stopped ? None : NotStopped;
    }

    GateRefusal operator()(const ArmCommand& arm) const
    {
        if (!arm.armed) return None;
        if (const GateRefusal refusal = stopRefusal(); refusal != None) return refusal;
        if (view.arming.phase != ArmingPhase::Requested) return NotConfirmed;
        return standsStill(view.robot->activity) ? None : Busy;
    }

    GateRefusal operator()(const BeginAtemCommand&) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (view.robot->exploring) return Exploring;
        return standsStill(view.robot->activity) || driving() ? None : Busy;
    }

    GateRefusal operator()(const DriveCommand& drive) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (view.robot->exploring) return Exploring;
        if (!standsStill(view.robot->activity) && !driving()) return Busy;
        return within(drive.speed, -limits.speed, limits.speed) ? None : OverLimit;
    }

    GateRefusal operator()(const AdvanceCommand& advance) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (view.robot->exploring) return Exploring;
        if (!standsStill(view.robot->activity)) return Busy;
        return within(advance.distance, 0.0, limits.advance) ? None : OverLimit;
    }

    GateRefusal operator()(const HoldFlippersCommand& hold) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (!standsStill(view.robot->activity)) return Busy;
        const bool fits = within(hold.front, limits.lowestFlipper, limits.highestFlipper)
                       && within(hold.rear, limits.lowestFlipper, limits.highestFlipper);
        return fits ? None : OverLimit;
    }

    GateRefusal operator()(const PressCommand& press) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (!view.robot->exploring) return NotExploring;
        if (!standsStill(view.robot->activity)) return Busy;
        return within(press.torque, 0.0, limits.torque) ? None : OverLimit;
    }

    GateRefusal operator()(const ProbeCommand& probe) const
    {
        if (const GateRefusal refusal = motionRefusal(); refusal != None) return refusal;
        if (!view.robot->exploring) return NotExploring;
        if (view.robot->activity != RobotActivity::Pressed) return NotPressed;
        if (!view.approval) return NotApproved;
        if (!isApprovalValid(view.approval->age, limits.approvalAge)) return ApprovalExpired;
        const bool isApproved =
            view.approval->bin == probe.bin && view.approval->side == probe.side;
        return isApproved ? None : OtherBin;
    }

    bool driving() const { return view.robot->activity == RobotActivity::Driving; }

    // Checks that operator, robot and link are present. If it returns None, view.robot has a value.
    GateRefusal linkRefusal() const
    {
        if (!isFresh(view.operatorAge, limits.operatorAge)) return OperatorAbsent;
        if (view.foreignSender) return ForeignSender;
        if (view.link != LinkState::Good || !view.robot) return LinkNotGood;
        if (!isFresh(view.statusAge, limits.statusAge)) return LinkNotGood;
        if (!isFresh(view.answerAge, limits.answerAge)) return NotAnswered;
        if (frame.epoch && *frame.epoch != view.robot->epoch) return WrongEpoch;
        return view.challenge != 0 && frame.challenge == view.challenge ? None : NotAnswered;
    }

    GateRefusal stopRefusal() const
    {
        if (const GateRefusal refusal = linkRefusal(); refusal != None) return refusal;
        const bool stopped = view.robot->activity == RobotActivity::Stopped;
        return view.stopLatched || stopped ? StopLatched : None;
    }

    GateRefusal motionRefusal() const
    {
        if (const GateRefusal refusal = stopRefusal(); refusal != None) return refusal;
        const bool here =
            view.arming.phase == ArmingPhase::Armed && view.arming.epoch == view.robot->epoch;
        return here && view.robot->armed ? None : NotArmed;
    }
};

GateRefusal refusalOf(FrameFault fault)
{
    const bool foreign = fault == FrameFault::UnknownId || fault == FrameFault::NotClassicData;
    return foreign ? NotAllowed : Malformed;
}

}  // namespace

double operatorPatience(const GateView& view, const GateLimits& limits)
{
    return view.moves ? limits.operatorAge : limits.operatorPause;
}

GateRefusal judge(const CanFrame& frame, const GateView& view, const GateLimits& limits)
{
    const auto unpacked = unpack(frame);
    if (const auto* fault = std::get_if<FrameFault>(&unpacked)) return refusalOf(*fault);
    const auto& content = std::get<Unpacked>(unpacked);
    if (content.kind == FrameKind::ConsoleHeartbeat)
        return isFresh(view.operatorAge, operatorPatience(view, limits)) ? None : OperatorAbsent;
    const std::optional<ReceivedCommand> sent = commandOf(content);
    return sent ? std::visit(Judge{view, limits, *sent}, sent->command) : NotAllowed;
}

SourceText describe(GateRefusal refusal)
{
    switch (refusal) {
    case None: return TR_NOOP("core", "may be sent");
    case NotAllowed: return TR_NOOP("core", "not a frame that a console sends");
    case Malformed: return TR_NOOP("core", "the frame is damaged");
    case OperatorAbsent: return TR_NOOP("core", "window or panel does not answer");
    case ForeignSender: return TR_NOOP("core", "somebody else sends this console's frames");
    case LinkNotGood: return TR_NOOP("core", "the link to the robot is not good");
    case NotAnswered:
        return TR_NOOP("core", "the robot does not answer: what arrives may be a recording");
    case WrongEpoch: return TR_NOOP("core", "the robot has begun a new arming");
    case StopLatched: return TR_NOOP("core", "STOP is latched");
    case NotStopped: return TR_NOOP("core", "the robot is not stopped");
    case NotArmed: return TR_NOOP("core", "not armed");
    case NotConfirmed: return TR_NOOP("core", "arming is not confirmed");
    case Exploring: return TR_NOOP("core", "an exploration is running");
    case NotExploring: return TR_NOOP("core", "no exploration is running");
    case Busy: return TR_NOOP("core", "the robot is busy");
    case NotPressed: return TR_NOOP("core", "the front flippers are not pressed to the ground");
    case OverLimit: return TR_NOOP("core", "the value is over its limit");
    case NotApproved: return TR_NOOP("core", "the probe is not approved");
    case ApprovalExpired: return TR_NOOP("core", "the approval is too old");
    case OtherBin: return TR_NOOP("core", "another bin was approved");
    }
    throw std::invalid_argument("describe: no such GateRefusal");
}

}  // namespace terratact
