#pragma once

#include <QSize>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): as CLI11 has it
class App;
}

namespace terratact {

/// What the command line of the console says.  Plain values; an empty one: it says nothing of that.
struct ConsoleOptions {
    std::string model, robot;  ///< files
    std::string terrain;       ///< a file of profiles, or varied
    std::string fault = "none";
    std::string can;  ///< interface
    bool transmit = false;
    std::string replay;     ///< file: a session, scenes, or a log of candump
    double speed = 1.0;     ///< seconds of a log per second
    std::string interface;  ///< of a log that has several
    std::optional<double> at{};
    std::string panel;             ///< file
    std::vector<std::string> dbc;  ///< files
    std::uint64_t seed = 1;
    std::string screenshot;               ///< file
    std::string theme, layout, language;  ///< by their names, see app/shell/preferences.h
    int fontScale = 0;                    ///< [%] 0: as preferred
    bool safeMode = false;
    std::string sessions;  ///< folder
    bool noRecord = false;
    bool errorsInWindow = false;  ///< why it cannot start, for starters without a terminal
    std::optional<QSize> size{};

    bool isPicture() const { return !screenshot.empty(); }
    /// Nothing is recorded that has happened before (a replay), or only for a picture.
    bool records() const { return !noRecord && replay.empty() && !isPicture(); }
};

/// Declares them to CLI11, which fills them in when it parses; `options` must outlive that.
void declareOptions(CLI::App& app, ConsoleOptions& options);

}  // namespace terratact
