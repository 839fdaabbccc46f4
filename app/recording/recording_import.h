#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"
#include "core/mapping/mapping.h"

namespace terratact {

struct RecordingImport {
    std::string file;     ///< recording of another program
    std::string mapping;  ///< mapping file
    std::string robot;    ///< robot file to store in the session
    std::string out;      ///< session to write; must not exist
    /// Text of a mapping, which errors call `mapping`; empty: the file is read.
    std::string mappingText{};
    /// Called with each message that is read and each line that is written. An exception ends the
    /// import, and no session is left.
    RecordingWatch watch{};
};

/// What an import wrote, and what the file and the mapping lacked.
struct ImportedSession {
    std::string format;       ///< of the recording
    std::int64_t frames = 0;  ///< rows of frames
    std::uint64_t lines = 0;  ///< lines of telemetry
    std::int64_t scenes = 0;  ///< lines at which the robot stood still with flippers pressed
    double seconds = 0.0;     ///< from the first to the last line
    std::string chain;        ///< last link of the hash chain
    std::vector<std::string> remarks{};
};

/// Writes a session (docs/sessions.md) from a recording. Its telemetry becomes the frames that a
/// robot would have sent for each line. If the mapping names recorded frames, it uses these. Lines at
/// which the robot stood still with flippers pressed (core/mapping/standing_presses.h) become scenes.
/// Errors name the file, the place and what to do; then no session is left.
Result<ImportedSession> importRecording(const RecordingImport& options);

}  // namespace terratact
