#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/link/can_text.h"
#include "core/base/result.h"
#include "drivers/can_bus.h"

namespace terratact {

// The subcommands of `terratact can`. Each returns an Error of one sentence if it fails.

struct CanDecodeOptions {
    std::string log;        ///< "-": standard input
    std::string interface;  ///< empty: all interfaces
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
    std::string csv;                 ///< output file; empty: none
    bool summaryOnly = false;        ///< prints no line per frame
};
/// Prints every frame of a log as text and the faults of each interface.
Status decodeCanLog(const CanDecodeOptions& options);

struct CanMonitorOptions {
    std::string bus;        ///< an interface, or a log to replay
    std::string interface;  ///< needed if the log holds several
    double speed = 1.0;     ///< replay speed
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
    double bitrate = 500'000.0;      ///< [bit/s] for the bus load
    std::optional<double> seconds;   ///< run time; empty: until the replay's end, or forever
};
/// Shows the traffic of a bus. On a terminal the table refreshes five times a second, otherwise once a second.
Status monitorCan(const CanMonitorOptions& options);

/// Prints the faults of an interface with the command that fixes each, or the content of a log. Returns an Error if it
/// cannot be used.
Status checkCan(const std::string& interfaceOrLog);

}  // namespace terratact
