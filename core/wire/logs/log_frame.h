#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/can_frame.h"

namespace terratact {

enum class LogDirection : std::uint8_t { Unknown, Received, Sent };

/// Frame of a log of CAN traffic from any program.
struct LoggedFrame {
    std::optional<double> time;  ///< time in the log [s], mostly since 1970
    std::string interface;
    CanFrame frame;  ///< Bytes beyond its length are 0. Flags of CAN FD (BRS, ESI) are not kept.
    LogDirection direction = LogDirection::Unknown;
    bool operator==(const LoggedFrame&) const = default;
};

}  // namespace terratact
