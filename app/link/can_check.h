#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "drivers/can_interface.h"

namespace terratact {

/// One result of a check.
struct CanFinding {
    enum class Level {
        Fine,
        Warning,  ///< works, but not at its best
        Problem,  ///< cannot be used
    };
    Level level = Level::Fine;
    Message what;    ///< a sentence without its full stop
    Message cure{};  ///< command that fixes the problem
    bool operator==(const CanFinding&) const = default;
};

/// State of a controller as printed by `ip -details link show`.
struct CanController {
    std::string state;              ///< "ERROR-ACTIVE", "BUS-OFF"; empty: not printed
    std::optional<long> bitrate{};  ///< [bit/s]
    bool operator==(const CanController&) const = default;
};
CanController controllerFrom(std::string_view linkDetails);

/// Returns what canSocketError() implies for the kernel and this user.
CanFinding socketFinding(int socketError);

/// Returns all findings about an interface, in the order in which they must be fixed. socketError: result of
/// canSocketError().
std::vector<CanFinding> findingsOf(const CanInterfaceFacts& facts, int socketError,
                                   const CanController& controller);

}  // namespace terratact
