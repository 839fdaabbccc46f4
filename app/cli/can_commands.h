#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/link/can_text.h"
#include "core/base/result.h"
#include "drivers/can_bus.h"

namespace terratact {

// The subcommands of `terratact can`.  Each returns what stood in its way, in one sentence.

struct CanDecodeOptions {
    std::string log;        ///< "-": standard input
    std::string interface;  ///< empty: all
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< files for frames that are not the protocol's
    std::string csv;                 ///< to be written; empty: none
    bool summaryOnly = false;        ///< no line for each frame
};
/// Prints every frame of a log in words, and what was wrong, for each interface.
Status decodeCanLog(const CanDecodeOptions& options);

struct CanMonitorOptions {
    std::string bus;        ///< an interface, or a log to be replayed
    std::string interface;  ///< of a log that holds several
    double speed = 1.0;     ///< of a replay
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< files for frames that are not the protocol's
    double bitrate = 500'000.0;      ///< [bit/s] for the load
    std::optional<double> seconds;   ///< then it ends; else at the end of a replay, or never
};
/// Shows what is on a bus: a table that is refreshed five times a second on a terminal, else once a second.
Status monitorCan(const CanMonitorOptions& options);

/// Prints what is wrong with an interface and which command mends it, or what a log holds.  An Error where it cannot be
/// used.
Status checkCan(const std::string& interfaceOrLog);

}  // namespace terratact
