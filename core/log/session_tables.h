#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

// What writing and reading a session share.  All throw SqliteError.

/// Refuses a file that is no session, one of another version, or one with a table, view, trigger or index that
/// is not ours.  The version: kFirstSessionVersion … kSessionVersion.
/// lonely: name of a file whose journal is not beside it, which then is why there is nothing in it yet; else empty.
std::int64_t requireSessionSchema(SqliteFile& file, const std::string& lonely = {});

/// Puts the start into meta; the hash of those rows, before the first link of the chain.
std::string writeSessionStart(SqliteFile& file, const SessionStart& start);

struct StoredStart {
    SessionStart start;
    std::string hash;
};
StoredStart readSessionStart(SqliteFile& file);

/// Draws as they are stored: 11 doubles each, 8 bytes, least first.
std::string bytesOfDraws(const std::vector<Heights>& draws);
/// Refuses bytes that are not whole draws, or a number that is not finite.
std::vector<Heights> drawsFrom(std::string_view bytes);

}  // namespace terratact
