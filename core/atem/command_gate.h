#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/atem/arming.h"
#include "core/limits.h"
#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"

namespace terratact {

/// Why a frame may not leave.
enum class GateRefusal : std::uint8_t {
    None,            ///< it may
    NotAllowed,      ///< not a frame that a console sends
    Malformed,       ///< one of them, but wrong in length, checksum, reserved bits or range
    OperatorAbsent,  ///< window or panel has not answered lately
    ForeignSender,   ///< somebody else sends this console's frames
    LinkNotGood,     ///< no status of the robot to rely on
    NotAnswered,  ///< no answer to a heartbeat, or not its challenge: what arrives may be a recording
    WrongEpoch,
    StopLatched,
    NotStopped,  ///< nothing to release
    NotArmed,
    NotConfirmed,  ///< arming without the operator's two actions
    Exploring,
    NotExploring,
    Busy,  ///< the robot is doing something that must end first
    NotPressed,
    OverLimit,
    NotApproved,      ///< a probe that nobody has approved
    ApprovalExpired,  ///< or too long ago
    OtherBin,         ///< or of another bin
};

/// The operator's word for one probe.
struct ProbeApproval {
    int bin = 0;
    double age = std::numeric_limits<double>::infinity();  ///< [s]
};

/// What the gate knows.  Nothing known: nothing but what makes safe may leave.
struct GateView {
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    LinkState link = LinkState::Unknown;  ///< of RobotStatus
    double statusAge = kNever;            ///< [s] of the last sound RobotStatus
    double answerAge = kNever;            ///< [s] Freshness::age
    std::uint16_t challenge = 0;          ///< of the newest answer since the last halt; 0: none
    double operatorAge = kNever;          ///< [s] since the slower of window and panel answered
    /// Something of the robot moves or was told to: then a heartbeat, too, needs an operator who answers now.
    bool moves = true;
    bool foreignSender = false;
    bool stopLatched = true;  ///< in the console
    ArmingState arming;
    std::optional<RobotStatus> robot;  ///< the last sound one
    std::optional<ProbeApproval> approval;
};

/// Values over the DBC's ranges never pass, whatever stands here.
struct GateLimits {
    double statusAge = kStaleAfter;                        ///< [s]
    double answerAge = kLinkLostAfter;                     ///< [s]
    double operatorAge = 0.1;                              ///< [s] of what commands or moves
    double operatorPause = 1.0;                            ///< [s] while nothing moves
    double approvalAge = kApprovalExpiry;                  ///< [s]
    double speed = 0.6;                                    ///< [m/s] either way
    double torque = 60.0;                                  ///< [N m]
    double advance = 0.1;                                  ///< [m]
    double lowestFlipper = -1.6, highestFlipper = 3.1416;  ///< [rad]
};

/// For how long [s] the operator may fail to answer before he counts as absent.
double operatorPatience(const GateView& view, const GateLimits& limits);

/// The last thing that every outgoing frame passes: judges the bytes themselves, so that it relies on
/// nobody who made them.  Deny by default.  Stop, Halt, AbortAtem and disarming always pass when well
/// formed; a heartbeat while the operator's window and panel answer, or pause while nothing moves; all else needs operator, link, the
/// robot's epoch and challenge, and the state that its row in the table of tests/core/atem/command_gate_test.cpp
/// shows.
/// Pure; a NaN in view or limits refuses.
GateRefusal judge(const CanFrame& frame, const GateView& view, const GateLimits& limits);

/// In words for the operator.
std::string describe(GateRefusal refusal);

}  // namespace terratact
