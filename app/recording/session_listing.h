#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/log/session_summary.h"

namespace terratact {

/// Files of a folder of recordings.
struct SessionFolderFiles {
    /// Paths of the *.tts files, the last name first: names begin with the date. Links are skipped.
    std::vector<std::string> paths;
    std::size_t leftOut = 0;  ///< older names beyond `most`
};

/// Returns the recordings of a folder, at most `most`. Errors name the folder that cannot be read. For an empty path,
/// which sessionFolder() may return, the Error names what sets the folder.
Result<SessionFolderFiles> sessionFilesIn(const std::string& folder, std::size_t most = 10'000);

/// A recording as a list shows it.
struct ListedSession {
    std::string path;
    std::int64_t bytes = 0;    ///< of the file and its journal
    std::int64_t written = 0;  ///< last write [ns] since 1970
    bool isRecorded = false;   ///< this program is recording it: it was not opened
    std::optional<SessionSummary> summary{};
    Message trouble{};                       ///< why there is no summary, without the file's name
    std::vector<std::string> reviewNotes{};  ///< of reviews (app/recording/review_notes.h)

    /// Returns the begin of the recording [ns] since 1970; without a summary the last write.
    std::int64_t wallTime() const;
    double seconds() const;      ///< duration; 0 without a summary
    std::int64_t notes() const;  ///< marks of the operator, and notes of reviews
};

/// Reads what a list shows of a recording (summarizeSession()). The notes of reviews are read from the
/// file beside it, if that has at most kMaxNotesFile bytes. stop: ends the reading early.
ListedSession listSession(const std::string& path, const std::stop_token& stop = {});
/// Returns what is known without opening a file that this program is recording.
ListedSession listRecorded(const std::string& path);
inline constexpr std::int64_t kMaxNotesFile = std::int64_t{1} << 20U;

}  // namespace terratact
