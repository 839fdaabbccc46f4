#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/log/rows/session_rows.h"
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

/// Value of estimate_bin.side for an estimate of one plane; otherwise it is "left" or "right".
inline constexpr std::string_view kBothSides = "both";

/// Appends 8 bytes, least significant byte first.
void addLittleEndian(std::string& bytes, double value);
/// Returns the number whose 8 bytes begin at `at`.
double littleEndianAt(std::string_view bytes, std::size_t at);

/// Returns the draws of an estimate as they are stored: 8 bytes for each double, least significant
/// byte first. A draw of one plane has 11 doubles. A joint draw of two sides has 22, the left side's
/// first. Throws std::invalid_argument if both sides have different numbers of draws.
std::string bytesOfDraws(const TwoTrackEstimate& estimate);
/// Returns draws from bytes; those of one plane are the draws of both sides. Throws for an incomplete
/// draw, or a number that is not finite.
SideDraws drawsFrom(std::string_view bytes, bool onePlane);

}  // namespace terratact
