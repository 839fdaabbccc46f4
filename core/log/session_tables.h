#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

// Functions that writer and reader of sessions share. All throw SqliteError.

/// Returns the version, kFirstSessionVersion … kSessionVersion. Throws for a file that is no
/// session, has another version, or has a foreign table, view, trigger or index. lonely: name of a
/// file whose journal is missing, which explains an empty file; else empty.
std::int64_t requireSessionSchema(SqliteFile& file, const std::string& lonely = {});

/// Writes the start into meta. Returns the hash of these rows, the start of the chain.
std::string writeSessionStart(SqliteFile& file, const SessionStart& start);

struct StoredStart {
    SessionStart start;
    std::string hash;
};
StoredStart readSessionStart(SqliteFile& file);

/// Returns draws as they are stored: 11 doubles each, 8 bytes, least significant byte first.
std::string bytesOfDraws(const std::vector<Heights>& draws);
/// Returns draws from bytes. Throws for an incomplete draw, or a number that is not finite.
std::vector<Heights> drawsFrom(std::string_view bytes);

}  // namespace terratact
