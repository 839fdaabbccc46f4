#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/rows/session_schema.h"
#include "core/store/canonical_bytes.h"
#include "core/store/sha256.h"
#include "core/store/sqlite.h"

namespace terratact {

// Hash chain that makes a session tamper-evident. Rows are committed in batches. With H = SHA-256
// and ‖ for concatenation:
//   frames_hash = H(rows of can_frame of the batch)
//   rows_hash   = H(H(rows of settings) ‖ H(rows of model) ‖ …)          in the order of kSessionRowTables
//   chain       = H(chain before ‖ id, t_first, t_last, frame_first, frame_count ‖ frames_hash ‖ rows_hash)
// The chain before the first batch is H(rows of meta). A row's bytes are its values in column
// order, each after its SQLite type (core/store/canonical_bytes.h). The chain detects changed,
// removed and added rows if its last link is known from elsewhere. Without that, whoever can write
// the file can compute a new chain.

/// Collects the bytes of rows for hashing.
class RowBytes {
public:
    void add(std::int64_t value);
    void add(int value) { add(std::int64_t{value}); }
    void add(double value);
    void add(std::string_view value);  ///< adds a text
    void add(const char* value) { add(std::string_view(value)); }
    void addBlob(std::string_view value);
    void addNull();
    void addRow(const SqliteStatement& row, int columns);  ///< adds all columns of the current row

    const std::string& bytes() const { return bytes_.bytes(); }
    void clear() { bytes_ = {}; }

private:
    CanonicalBytes bytes_;
};

/// Index entry of a batch.
struct SessionBatch {
    std::int64_t id = 0;
    std::int64_t first = 0, last = 0;  ///< times of its first and last row [ns]
    std::int64_t frameFirst = 0, frameCount = 0;
};

struct BatchHashes {
    std::string frames{}, rows{};
};

/// Computes rows_hash of one batch.
class RowsHash {
public:
    void add(std::size_t table, std::string_view rowBytes) { tables_.at(table).add(rowBytes); }
    std::string finish();

private:
    std::array<Sha256, kSessionRowTables.size()> tables_;
};

/// Returns the chain after a batch.
std::string chained(std::string_view before, const SessionBatch& batch, const BatchHashes& hashes);

}  // namespace terratact
