#include "app/recording/session_listing.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "app/recording/review_notes.h"
#include "app/recording/session_folder.h"
#include "app/recording/session_text.h"
#include "core/base/system_message.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// Returns the cause of an error that names a file.
Message causeOf(const Error& error)
{
    return error.message.arguments.empty() ? error.message : error.message.arguments.back();
}

std::vector<std::string> notesOfReviews(const std::string& session)
{
    std::vector<std::string> texts;
    if (sizeOf(notesPath(session)) > kMaxNotesFile) return texts;
    const auto notes = readNotes(session);
    if (!notes) return texts;
    texts.reserve(notes->size());
    for (const ReviewNote& note : *notes) texts.push_back(note.text);
    return texts;
}

}  // namespace

Result<SessionFolderFiles> sessionFilesIn(const std::string& folder, std::size_t most)
{
    if (folder.empty())
        return Error{TR_NOOP("core", "there is no home folder that may hold recordings: name a "
                                     "folder, or set HOME or XDG_STATE_HOME")};
    std::error_code unreadable;
    (void)std::filesystem::directory_iterator(folder, unreadable);
    if (unreadable)
        return fileError(folder, Message(TR_NOOP("core", "the folder cannot be read: %1"),
                                         systemMessage(unreadable.value())));
    SessionFolderFiles found{.paths = sessionsIn(folder)};
    std::ranges::sort(found.paths, std::greater<>());
    if (found.paths.size() > most) {
        found.leftOut = found.paths.size() - most;
        found.paths.resize(most);
    }
    return found;
}

std::int64_t ListedSession::wallTime() const
{
    if (!summary) return written;
    SessionStart start;
    start.wallTime = summary->wallTime;
    return wallTimeOf(start, summary->begin);
}

double ListedSession::seconds() const
{
    return summary ? secondsOf(summary->end - summary->begin) : 0.0;
}

std::int64_t ListedSession::notes() const
{
    return (summary ? summary->marks : 0) + static_cast<std::int64_t>(reviewNotes.size());
}

ListedSession listRecorded(const std::string& path)
{
    return {.path = path,
            .bytes = sizeOf(path) + sizeOf(path + "-wal"),
            .written = writtenAt(path),
            .isRecorded = true};
}

ListedSession listSession(const std::string& path, const std::stop_token& stop)
{
    ListedSession listed = listRecorded(path);
    listed.isRecorded = false;
    auto summary = summarizeSession(path, stop);
    if (summary)
        listed.summary = *std::move(summary);
    else
        listed.trouble = causeOf(summary.error());
    listed.reviewNotes = notesOfReviews(path);
    return listed;
}

}  // namespace terratact
