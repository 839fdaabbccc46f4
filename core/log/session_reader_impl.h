#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/log/rows/session_row_reader.h"
#include "core/log/rows/session_schema.h"
#include "core/log/rows/session_tables.h"
#include "core/log/session_reader.h"
#include "core/store/sqlite.h"

namespace terratact {

/// Returns the name without its folder.
inline std::string nameWithoutFolder(const std::string& path)
{
    return path.substr(path.find_last_of('/') + 1);
}

/// Reads the rows of a session, part by part, and judges them by the hashes.
struct SessionReader::Impl {
    using Hash = std::array<char, Sha256::kBytes>;

    Impl(std::string name, SqliteFile opened, bool isSealed, std::size_t batchesAtATime)
        : path(std::move(name)), file(std::move(opened)), sealed(isSealed), atATime(batchesAtATime)
    {
        lastRow.fill(std::numeric_limits<std::int64_t>::min());
    }

    /// Batches that are read together; they follow each other.
    struct Part {
        std::vector<StoredBatch> batches;
        std::int64_t from, to;  ///< range of batch numbers of the rows in this part
    };

    bool readMore();
    Part nextPart();
    void judge(const Part& part);
    std::map<std::int64_t, std::string> rowHashes(const Part& part);
    void readRows(const Part& part);
    template <class Take>
    std::int64_t forRows(std::size_t table, const Part& part, Take visit);
    void addDamage(const SessionBatch& batch, const Message& why);
    bool isSound(std::int64_t batch) const
    {
        return byId(batches, batch) && !std::binary_search(unsound.begin(), unsound.end(), batch);
    }
    std::vector<FrameRow> frames(std::size_t batch);
    SideDraws draws(std::int64_t estimate);
    void countStrayFrames();
    void checkStructure();
    void missJournal();

    std::string path;
    SqliteFile file;
    bool sealed;
    bool lacksJournal = false, structureChecked = false;
    bool chainCounts = true;  ///< a batch must follow the one before it
    std::size_t atATime;
    StoredStart stored;
    std::vector<SessionBatch> batches;
    std::vector<Hash> frameHashes;  ///< hash of each batch's frames
    std::string chain;              ///< the file's own link after batches.back()
    std::string proven;             ///< last valid link
    std::optional<SessionDamage> broken;
    std::vector<std::int64_t> unsound;  ///< batches whose rows are hidden, ascending
    std::vector<SessionDamage> damage;
    SessionTime begin = 0, end = 0;
    SessionRows rows;
    std::array<std::int64_t, kSessionRowTables.size()> lastRow;  ///< last row read of each table
    std::array<std::size_t, kSessionRowTables.size()> rowCount{};
    std::map<std::int64_t, std::int64_t>
        drawn;  ///< bytes of the draws of each estimate that was read
    std::int64_t drawnBytes = 0;
};

}  // namespace terratact
