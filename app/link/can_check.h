#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/can_interface.h"

namespace terratact {

/// One thing that was looked at.
struct CanFinding {
    enum class Level {
        Fine,
        Warning,  ///< works, but not as well as it could
        Problem,  ///< cannot be used
    };
    Level level = Level::Fine;
    std::string what;    ///< a sentence without its full stop
    std::string cure{};  ///< the command that mends it
    bool operator==(const CanFinding&) const = default;
};

/// What `ip -details link show` says of a controller.
struct CanController {
    std::string state;              ///< "ERROR-ACTIVE", "BUS-OFF"; empty: not told
    std::optional<long> bitrate{};  ///< [bit/s]
    bool operator==(const CanController&) const = default;
};
CanController controllerFrom(std::string_view linkDetails);

/// What canSocketError() says about the kernel and this user.
CanFinding socketFinding(int socketError);

/// Everything about an interface in the order in which it has to be mended.  socketError: of
/// canSocketError().
std::vector<CanFinding> findingsOf(const CanInterfaceFacts& facts, int socketError,
                                   const CanController& controller);

}  // namespace terratact
