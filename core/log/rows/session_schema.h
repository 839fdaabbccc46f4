#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/store/content_kind.h"  // kSessionApplicationId

namespace terratact {

// Tables of a session file (`*.tts`), an SQLite file; docs/sessions.md explains them. Readers
// refuse any other schema (requireSessionSchema() in session_tables.h). What is whole in a damaged
// file is saved by core/log/session_salvage.h.

/// Version 1 does not record how a bin was touched; all its forces and currents count as measured.
/// Versions 1 and 2 hold phases, failures and causes of disarming as English texts
/// (core/log/rows/recorded_words.h), and no messages. Versions 1 to 3 hold only the means of left and right
/// forces in a scene, and no differential. Their probes are of the middle alone, their estimates of
/// one plane. Versions 1 to 4 hold no memory of the way, and no networks that use it. Versions 1 to
/// 5 hold what was on the screen in English only. Versions 1 to 6 hold both currents of an axle or
/// none. In version 7 one alone may be missing, which older readers take for 0 A. Its tables are
/// those of version 6.
inline constexpr std::int64_t kSessionVersion = 7;
inline constexpr std::int64_t kFirstSessionVersion = 1;

struct SchemaEntry {
    const char* type;
    const char* name;
    const char* sql;
};

using SessionSchema = std::array<SchemaEntry, 15>;

/// Returns the schema of a version, kFirstSessionVersion … kSessionVersion, sorted by name. In the
/// tables of kSessionRowTables, the column `batch` holds the number of the batch.
SessionSchema sessionSchema(std::int64_t version);

/// Returns the number of columns of a table in that version.
int sessionColumns(std::int64_t version, std::string_view table);

/// Tables whose rows make a batch's `rows_hash` (formula: session_hash.h), in this order, each in the order of rowid.
inline constexpr std::array<std::string_view, 10> kSessionRowTables{
    "settings", "model",        "scene",    "scene_truth",    "estimate",
    "reading",  "estimate_bin", "proposal", "proposal_offer", "event"};

/// Largest number of batches of one file, which readers keep an index of: four and a half days at
/// five per second.
inline constexpr std::int64_t kMaxBatches = 2'000'000;

/// Largest text of a row [bytes]. The writer cuts longer texts, readers refuse them.
inline constexpr std::size_t kMaxTextBytes = 65'536;
/// Latest start of a session: the year 2116 [ns since 1970]. Row times are added to it.
inline constexpr std::int64_t kMaxWallTime = std::int64_t{1} << 62U;
/// Largest value of meta [bytes], such as the robot file.
inline constexpr std::size_t kMaxMetaBytes = 1U << 20U;

/// Bits of can_frame.flags. The length of the data is stored above them.
inline constexpr std::int64_t kExtendedFlag = 1, kRemoteFlag = 2, kErrorFlag = 4, kFdFlag = 8,
                              kSentFlag = 16, kLocalFlag = 32;
inline constexpr int kLengthShift = 8;

}  // namespace terratact
