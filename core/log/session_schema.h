#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/store/content_kind.h"  // kSessionApplicationId

namespace terratact {

// Tables of a session file (`*.tts`), an SQLite file; docs/sessions.md explains them.  Whoever reads one
// refuses any other schema.

inline constexpr std::int64_t kSessionVersion = 2;
/// Version 1 does not say how a bin was touched, and its forces and currents are all measured.
inline constexpr std::int64_t kFirstSessionVersion = 1;

struct SchemaEntry {
    const char* type;
    const char* name;
    const char* sql;
};

using SessionSchema = std::array<SchemaEntry, 15>;

/// Sorted by name. The tables of kSessionRowTables have the number of their batch in the column `batch`.
/// version: kFirstSessionVersion … kSessionVersion.
SessionSchema sessionSchema(std::int64_t version);

/// Columns that version 2 adds at the end of settings, estimate and estimate_bin.
constexpr int addedColumns(std::int64_t version)
{
    return version >= 2 ? 1 : 0;
}

/// The tables whose rows are hashed together as a batch's `rows_hash`, in this order, each in the order of rowid.
inline constexpr std::array<std::string_view, 10> kSessionRowTables{
    "settings", "model",        "scene",    "scene_truth",    "estimate",
    "reading",  "estimate_bin", "proposal", "proposal_offer", "event"};

/// Of one file: readers hold an index of them.  At five per second they are four days and a half.
inline constexpr std::int64_t kMaxBatches = 2'000'000;

/// Bytes of one text of a row; the writer cuts longer ones, readers refuse them.
inline constexpr std::size_t kMaxTextBytes = 65'536;
/// [ns] since 1970 of the start: the year 2116; times are added to it.
inline constexpr std::int64_t kMaxWallTime = std::int64_t{1} << 62U;
/// Bytes of one value of meta, the robot file among them.
inline constexpr std::size_t kMaxMetaBytes = 1U << 20U;

/// Bits of can_frame.flags; the length of the data stands above them.
inline constexpr std::int64_t kExtendedFlag = 1, kRemoteFlag = 2, kErrorFlag = 4, kFdFlag = 8,
                              kSentFlag = 16, kLocalFlag = 32;
inline constexpr int kLengthShift = 8;

}  // namespace terratact
