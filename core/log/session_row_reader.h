#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "core/log/session_hash.h"
#include "core/log/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

// Rows of a session file as values.  All throw RefusedRow (core/log/checked_row.h) where a row holds what no
// session has, and SqliteError where a column has another type.

/// The present row of `SELECT * FROM batch`; the link of the chain after it.
struct StoredBatch {
    SessionBatch batch;
    BatchHashes hashes;
    std::string link;
};
StoredBatch batchFrom(const SqliteStatement& select);

/// The present row of `SELECT * FROM can_frame`.
FrameRow frameFrom(const SqliteStatement& select);

/// The row of that id; null where there is none.  Rows are in the order of their ids.
template <class Rows>
auto* byId(Rows& rows, std::int64_t id)
{
    const auto found = std::lower_bound(rows.begin(), rows.end(), id,
                                        [](const auto& row, std::int64_t i) { return row.id < i; });
    return found != rows.end() && found->id == id ? &*found : nullptr;
}

/// All rows of a session but its frames and draws.
class SessionRows {
public:
    /// Takes the present row of `SELECT *` from kSessionRowTables[table].  What it refers to has been taken.
    void take(std::size_t table, const SqliteStatement& select);

    std::vector<ModelRow> models;
    std::vector<SceneRow> scenes;
    std::vector<EstimateRow> estimates;  ///< without their draws
    std::vector<ProposalRow> proposals;
    std::vector<EventRow> events;

private:
    std::map<std::int64_t, Settings> settings_;
};

}  // namespace terratact
