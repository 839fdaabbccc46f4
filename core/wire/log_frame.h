#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/can_frame.h"

namespace terratact {

enum class LogDirection : std::uint8_t { Unknown, Received, Sent };

/// A frame of a log of CAN traffic, whatever program wrote it.
struct LoggedFrame {
    std::optional<double> time;  ///< [s] as the log has it: most often since 1970
    std::string interface;
    CanFrame frame;  ///< its bytes beyond its length are 0; flags of CAN FD (BRS, ESI) are not kept
    LogDirection direction = LogDirection::Unknown;
    bool operator==(const LoggedFrame&) const = default;
};

}  // namespace terratact
