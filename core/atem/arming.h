#pragma once

#include <cstdint>
#include <string>

namespace terratact {

/// How the console comes to be allowed to move a robot: two distinct actions of the operator within 5 s
/// over a link that has been good for 1 s, then the robot's word.  Anything wrong disarms at once, and
/// nothing ever arms again by itself.
///
///   Disarmed ──wanted──▶ Confirming ──confirmed──▶ Requested ──robotArmed──▶ Armed
enum class ArmingPhase : std::uint8_t {
    Disarmed,
    Confirming,  ///< waits for the operator's second action
    Requested,   ///< waits for the robot
    Armed,
};

/// Why it is not armed.
enum class DisarmCause : std::uint8_t {
    None,  ///< not disarmed, or never armed
    Operator,
    Stop,
    OperatorAbsent,  ///< window or panel did not answer
    ForeignSender,   ///< somebody else sends this console's frames
    LinkNotGood,
    AlreadyArmed,  ///< the robot is armed, but not by this console
    ConfirmTimeout,
    RequestTimeout,
    RobotDisarmed,
    EpochChanged,  ///< the robot has begun a new epoch: rebooted, or armed by somebody else
};

struct ArmingState {
    ArmingPhase phase = ArmingPhase::Disarmed;
    DisarmCause cause = DisarmCause::None;
    double since = 0.0;      ///< [s] when the phase began
    std::uint8_t epoch = 0;  ///< of this arming; 0 unless Armed
    bool operator==(const ArmingState&) const = default;
};

struct ArmingInput {
    double now = 0.0;          ///< [s] any monotonic clock
    bool wanted = false;       ///< first action, an edge
    bool confirmed = false;    ///< second action, an edge
    bool disarmed = false;     ///< the operator gives it up
    bool stopLatched = false;  ///< here or on the robot
    /// Window and panel have answered within 100 ms, or 1 s where nothing moves (operatorPatience()).
    bool operatorPresent = false;
    bool foreignSender = false;  ///< a frame of the console's came from outside
    double linkGoodFor = 0.0;    ///< [s] without interruption; 0: the link is not good
    bool robotArmed = false;     ///< of the newest RobotStatus
    std::uint8_t robotEpoch = 0;
};

struct ArmingLimits {
    double linkGood = 1.0;  ///< [s] before the first action counts
    double confirm = 5.0;   ///< [s]
    double request = 1.0;   ///< [s] for the robot's answer
};

/// One tick, no clock.  Throws std::invalid_argument unless in.now is finite.
ArmingState nextArming(const ArmingState& state, const ArmingInput& in, const ArmingLimits& limits);

std::string describe(ArmingPhase phase);
std::string describe(DisarmCause cause);

}  // namespace terratact
