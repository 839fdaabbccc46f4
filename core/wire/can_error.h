#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/can_frame.h"

namespace terratact {

/// What a CAN controller may do, by its own count of errors.
enum class ControllerState : std::uint8_t {
    Active,   ///< all
    Warning,  ///< more than 95 errors: still all
    Passive,  ///< more than 127 errors: sends and receives, but no longer objects
    BusOff,   ///< more than 255 errors in sending: nothing, until it is restarted
};

// What Linux says in an error frame: classes in the identifier, their details in the data.  Bytes that the
// frame is too short for count as 0, "unspecified".  Both throw std::invalid_argument unless frame.error.

/// The state that the controller says to be in now; empty where the frame does not tell.
std::optional<ControllerState> controllerState(const CanFrame& frame);

/// In words: "bus-off; 136 transmit and 12 receive errors".  Bits without a meaning are named by number.
std::string describeError(const CanFrame& frame);

}  // namespace terratact
