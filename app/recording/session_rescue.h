#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Ends the sentence about frames whose recorded hashes are lost.
inline constexpr const char* kUnproven =
    "; the hashes that were recorded with them are lost: nothing proves that they are what was "
    "recorded";

/// Consecutive batches that are missing or damaged.
struct LostSpan {
    SessionTime first, last;
    std::int64_t batches;
};

/// A new session with the undamaged rows of one that could not be closed in place.
struct SavedSession {
    std::string out;
    std::int64_t leftOut = 0;         ///< rows that refer to a lost row
    bool isProven = true;             ///< the recorded hashes prove the rows
    bool isCut = false;               ///< the file ends before its last page
    bool startIsWhole = true;         ///< source, robot and wall time are known
    std::vector<LostSpan> spans{};    ///< sorted by time; spans that touch are joined
    std::set<std::int64_t> draws{};   ///< estimates with undamaged draws
    std::vector<std::string> rest{};  ///< other losses
};

/// Result of closing a session whose program died.
struct SessionRescue {
    bool recovered = false;  ///< it was closed in place; false: it was closed already
    std::string why;         ///< reason that it was copied instead; empty: it was not copied
    SavedSession saved{};    ///< valid with a reason
};

/// Closes a session whose program died. If it or its journal is damaged, its undamaged rows are copied to a new
/// session. So are the rows of a session that lacks its journal or is read-only. What SQLite cannot read is salvaged
/// page by page (core/log/session_salvage.h). The old file and its journal then stay unchanged. out: the new session;
/// empty: NAME-recovered.tts beside it.
/// Errors: the session is in use, is a symbolic link, or contains no valid part; `out` exists or cannot be made.
Result<SessionRescue> rescueSession(const std::string& path, const std::string& out);

}  // namespace terratact
