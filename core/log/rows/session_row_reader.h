#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

// Converts rows of a session file to values. All functions throw RefusedRow
// (core/log/rows/checked_row.h) if a row holds what no session can hold. They throw SqliteError if a
// column has another type.

/// The current row of `SELECT * FROM batch`, with the link of the chain after it.
struct StoredBatch {
    SessionBatch batch;
    BatchHashes hashes;
    std::string link;
};
StoredBatch batchFrom(const SqliteStatement& select);

/// Returns the current row of `SELECT * FROM can_frame`.
FrameRow frameFrom(const SqliteStatement& select);

/// Returns the row of that id; null if there is none. Rows must be in the order of their ids.
template <class Rows>
auto* byId(Rows& rows, std::int64_t id)
{
    const auto found = std::lower_bound(rows.begin(), rows.end(), id,
                                        [](const auto& row, std::int64_t i) { return row.id < i; });
    return found != rows.end() && found->id == id ? &*found : nullptr;
}

/// All rows of a session except frames and draws.
class SessionRows {
public:
    /// Adds the current row of `SELECT *` from kSessionRowTables[table]. The rows that it refers to
    /// must have been added before.
    void add(std::size_t table, const SqliteStatement& select);

    std::vector<ModelRow> models;
    std::vector<SceneRow> scenes;
    std::vector<EstimateRow> estimates;  ///< without their draws
    std::vector<ProposalRow> proposals;
    std::vector<EventRow> events;

private:
    std::map<std::int64_t, Settings> settings_;
};

}  // namespace terratact
