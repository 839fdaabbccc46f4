#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/atem/arming.h"
#include "core/base/message.h"
#include "core/limits.h"
#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"

namespace terratact {

/// Reason why the gate refuses a frame.
enum class GateRefusal : std::uint8_t {
    None,            ///< the frame may be sent
    NotAllowed,      ///< a console sends no such frame
    Malformed,       ///< wrong length, checksum, reserved bits or range
    OperatorAbsent,  ///< window or panel has not responded recently
    ForeignSender,   ///< another sender uses this console's frame identifiers
    LinkNotGood,     ///< no recent status of the robot
    /// No answer to a heartbeat, or not its challenge: the telemetry may be a recording.
    NotAnswered,
    WrongEpoch,
    StopLatched,
    NotStopped,  ///< there is no stop to release
    NotArmed,
    NotConfirmed,  ///< arming without the operator's two actions
    Exploring,
    NotExploring,
    Busy,  ///< the robot must first end its present action
    NotPressed,
    OverLimit,
    NotApproved,      ///< the probe is not approved
    ApprovalExpired,  ///< the approval is too old
    OtherBin,         ///< the approval is for another bin or another side
};

/// The operator's approval of one probe.
struct ProbeApproval {
    int bin = 0;
    double age = std::numeric_limits<double>::infinity();  ///< [s]
    ProbeSide side = ProbeSide::Middle;
};

/// State that the gate judges by. In the default state only safe commands may pass.
struct GateView {
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    LinkState link = LinkState::Unknown;  ///< from RobotStatus
    double statusAge = kNever;            ///< age of the last valid RobotStatus [s]
    double answerAge = kNever;            ///< [s] Freshness::age
    std::uint16_t challenge = 0;          ///< from the newest answer since the last halt; 0: none
    double operatorAge = kNever;  ///< time since the slower of window and panel responded [s]
    /// True if the robot moves, or was commanded to move. A heartbeat then also needs an operator
    /// who responds now.
    bool moves = true;
    bool foreignSender = false;
    bool stopLatched = true;  ///< STOP is latched in the console
    ArmingState arming;
    std::optional<RobotStatus> robot;  ///< the last valid status
    std::optional<ProbeApproval> approval;
};

/// Limits of the gate. Values beyond the ranges of the DBC file never pass.
struct GateLimits {
    double statusAge = kStaleAfter;        ///< [s]
    double answerAge = kLinkLostAfter;     ///< [s]
    double operatorAge = 0.1;              ///< [s] for commands, and while something moves
    double operatorPause = 1.0;            ///< [s] while nothing moves
    double approvalAge = kApprovalExpiry;  ///< approval expiry [s]
    double speed = 0.6;                    ///< [m/s] in both directions
    double torque = 60.0;                  ///< [N m]
    double advance = kMaxAdvance;          ///< [m]
    double lowestFlipper = -1.6, highestFlipper = 3.1416;  ///< [rad]
};

/// Returns the time [s] without a response after which the operator counts as absent.
double operatorPatience(const GateView& view, const GateLimits& limits);

/// Judges every outgoing frame by its bytes, as the last step before the bus. It denies by default.
/// Stop, Halt, AbortAtem and disarming always pass if they are well formed. A heartbeat passes
/// while the operator's window and panel respond; while nothing moves they may pause. Every other
/// command needs the operator, the link, and the robot's epoch and challenge. A frozen window
/// therefore ends a drive: after operatorAge no Drive frame passes, and ConsoleLink disarms the robot.
/// Its dead-man acts if even that does not arrive.
/// Each command also needs a state; the table of tests/core/atem/command_gate_test.cpp has its row.
/// Pure function; a NaN in view or limits refuses.
GateRefusal judge(const CanFrame& frame, const GateView& view, const GateLimits& limits);

/// Returns a text for the operator.
SourceText describe(GateRefusal refusal);

}  // namespace terratact
