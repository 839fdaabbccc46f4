#pragma once

#include <QSize>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/runtime/file_guard.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace terratact {

/// The console's command line as plain values; an empty value means not given.
struct ConsoleOptions {
    std::string model, robot;  ///< files
    std::string terrain;       ///< a profile file, or "varied"
    std::string fault = "none";
    std::string can;  ///< CAN interface
    bool transmit = false;
    std::string replay;     ///< file: a session, scenes, or a candump log
    double speed = 1.0;     ///< replay seconds per second
    std::string interface;  ///< needed if the log holds several
    std::optional<double> at{};
    std::string panel;             ///< panel file
    std::vector<std::string> dbc;  ///< DBC files
    std::uint64_t seed = 1;
    std::string screenshot;               ///< picture file
    std::string theme, layout, language;  ///< names as in app/shell/preferences/preferences.h
    std::string lengthUnit, angleUnit;    ///< names as in app/display/units.h
    int fontScale = 0;                    ///< [%] 0: as preferred
    bool safeMode = false;
    std::string sessions;  ///< folder of the sessions
    bool noRecord = false;
    bool errorsInWindow = false;  ///< shows start errors in a window, for starts without a terminal
    std::optional<QSize> size{};

    bool isPicture() const { return !screenshot.empty(); }
    /// Returns false for a replay and for a picture, which are not recorded.
    bool records() const { return !noRecord && replay.empty() && !isPicture(); }
};

/// Returns the files that these options name: those read, and the picture that is written.
CommandFiles filesOf(const ConsoleOptions& options);

/// Declares the options to CLI11, which fills them during parsing; `options` must outlive that.
void declareOptions(CLI::App& app, ConsoleOptions& options);

}  // namespace terratact
