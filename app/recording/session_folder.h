#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace terratact {

inline constexpr const char* kSessionSuffix = ".tts";

/// Returns the size of a file [byte]; 0 if it cannot be read.
std::int64_t sizeOf(const std::string& path);

/// Returns a file's last write [ns] since 1970; 0 if unknown.
std::int64_t writtenAt(const std::string& path);

/// Returns the folder of this user's sessions: terratact/sessions in userFolder() of XDG_STATE_HOME and .local/state.
/// Empty: no folder.
std::string sessionFolder();

/// Returns the free bytes of a disk; empty if unknown.
std::optional<std::uint64_t> freeBytes(const std::string& folder);

/// Returns the session files of a folder, closed or not, sorted by name. Symbolic links are skipped, so that repair and
/// deletion stay in this folder.
std::vector<std::string> sessionsIn(const std::string& folder);

/// Closes sessions whose program died (recoverSession). Returns one sentence per closed or unrecoverable session.
/// Sessions that are being recorded, and those with a damaged journal, are not touched.
std::vector<Message> recoverDeadSessions(const std::vector<std::string>& paths);

/// Retention limits set by the user; 0: no limit.
struct RetentionLimits {
    double days = 0.0;
    double gigabytes = 0.0;  ///< total size of all closed sessions
    bool confirmed = false;  ///< the user has once confirmed deletion beyond the limits
    bool operator==(const RetentionLimits&) const = default;
};

/// Deletes closed sessions beyond the limits, oldest first, and returns one sentence for each. Without confirmation it
/// deletes nothing and returns one sentence about what it would delete.
///
/// A session's end is the later of its recorded end and its file's last write. One of them may be 1970 after a flat
/// clock battery. A session with an impossible time is never deleted: before 2020, or more than a day after `now`.
/// Nothing is deleted if `now` is before 2020 or no limit is set. Files that are no closed sessions, or are reached
/// through a symbolic link, are never deleted. now: [ns] since 1970. goesOn: called before each file; false cancels.
std::vector<Message> applyRetention(
    const std::vector<std::string>& paths, const RetentionLimits& limits, std::int64_t now,
    const std::function<bool()>& goesOn = [] { return true; });

/// Returns this computer's clock [ns] since 1970.
std::int64_t wallNow();

}  // namespace terratact
