#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Reason why feel forward ended. A reason from Stale on forbids the next advance at this pose.
enum class LoopEnd : std::uint8_t {
    None,           ///< feel forward is running, or was never requested
    LetGo,          ///< the dead-man control was released
    Aborted,        ///< the operator aborted it, or gave another command
    Stop,           ///< STOP
    Fault,          ///< see AtemState::failure
    ProbeProposed,  ///< a probe would decide: the operator is asked
    Stale,          ///< telemetry is stale, or was interrupted since the scene
    NoVerdict,      ///< there is no estimate
    SensorFault,    ///< a sensor is suspected
    Contradiction,  ///< on the estimated ground the robot would read other values
    Withheld,       ///< the verdict is withheld for another reason
    Blocked,        ///< the verdict is BLOCKED
    NotFelt,        ///< the flippers press on nothing, or the touch is not recorded
    ShortReach,     ///< the ground is felt less far than the flippers reach
    Bounded,        ///< bins before the horizon are bounded or felt in part
    Undecided,      ///< CANNOT TELL, although the ground is felt
    ShortHorizon,   ///< CLEAR, but felt no further than the advance
    Attitude,       ///< pitch or roll is beyond its limit
    NoOdometry,     ///< the robot does not report the way of its tracks
};

/// Returns a text for the operator.
SourceText describe(LoopEnd end);

/// Returns the name that a session file holds.
std::string_view name(LoopEnd end);

}  // namespace terratact
