#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Arming: how the console gets permission to move a robot. It takes two actions of the operator
/// within 5 s, over a link that has been good for 1 s. The robot must then confirm. Any fault
/// disarms at once. Nothing arms automatically.
///
///   Disarmed ──wanted──▶ Confirming ──confirmed──▶ Requested ──robotArmed──▶ Armed
enum class ArmingPhase : std::uint8_t {
    Disarmed,
    Confirming,  ///< waits for the operator's second action
    Requested,   ///< waits for the robot
    Armed,
};

/// Reason why the console is not armed.
enum class DisarmCause : std::uint8_t {
    None,  ///< armed, or never armed
    Operator,
    Stop,
    OperatorAbsent,  ///< window or panel did not respond
    ForeignSender,   ///< another sender uses this console's frame identifiers
    LinkNotGood,
    AlreadyArmed,  ///< the robot is armed, but not by this console
    ConfirmTimeout,
    RequestTimeout,
    RobotDisarmed,
    EpochChanged,  ///< the robot has a new epoch: it rebooted, or another console armed it
};

struct ArmingState {
    ArmingPhase phase = ArmingPhase::Disarmed;
    DisarmCause cause = DisarmCause::None;
    double since = 0.0;      ///< time at which the phase began [s]
    std::uint8_t epoch = 0;  ///< epoch of this arming; 0 unless Armed
    bool operator==(const ArmingState&) const = default;
};

struct ArmingInput {
    double now = 0.0;          ///< [s] any monotonic clock
    bool wanted = false;       ///< first action of the operator, an edge
    bool confirmed = false;    ///< second action of the operator, an edge
    bool disarmed = false;     ///< the operator disarms
    bool stopLatched = false;  ///< STOP is latched in the console or on the robot
    /// True if window and panel responded within 100 ms, or within 1 s while nothing moves
    /// (operatorPatience()).
    bool operatorPresent = false;
    bool foreignSender = false;  ///< a frame of the console came from another sender
    double linkGoodFor = 0.0;    ///< [s] without interruption; 0: the link is not good
    bool robotArmed = false;     ///< from the newest RobotStatus
    std::uint8_t robotEpoch = 0;
};

struct ArmingLimits {
    double linkGood = 1.0;  ///< [s] a good link is needed before the first action
    double confirm = 5.0;   ///< [s]
    double request = 1.0;   ///< [s] for the robot's confirmation
};

/// Computes one tick, without a clock. Throws std::invalid_argument unless in.now is finite.
ArmingState nextArming(const ArmingState& state, const ArmingInput& in, const ArmingLimits& limits);

SourceText describe(ArmingPhase phase);
SourceText describe(DisarmCause cause);

/// Return the names that a session file holds, and the values of these names.
std::string_view name(ArmingPhase phase);
std::string_view name(DisarmCause cause);
std::optional<ArmingPhase> armingPhaseFromName(std::string_view text);
std::optional<DisarmCause> disarmCauseFromName(std::string_view text);

}  // namespace terratact
