#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/can_frame.h"

namespace terratact {

/// State of a CAN controller by its own error counters.
enum class ControllerState : std::uint8_t {
    Active,   ///< may do everything
    Warning,  ///< more than 95 errors: may still do everything
    Passive,  ///< more than 127 errors: sends and receives, but does not signal errors
    BusOff,   ///< more than 255 transmit errors: no traffic until a restart
};

// Error frames of Linux: classes in the identifier, details in the data. Bytes beyond the frame's
// length count as 0, "unspecified". Both functions throw std::invalid_argument unless frame.error.

/// Returns the state that the controller reports; empty if the frame does not report one.
std::optional<ControllerState> controllerState(const CanFrame& frame);

/// Returns a text: "bus-off; 136 transmit and 12 receive errors". Bits without a meaning are named
/// by number.
std::string describeError(const CanFrame& frame);

}  // namespace terratact
