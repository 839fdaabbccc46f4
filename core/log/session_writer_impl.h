#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_schema.h"
#include "core/log/rows/session_table_insert.h"
#include "core/log/rows/session_tables.h"
#include "core/log/session_writer.h"
#include "core/store/sqlite.h"

namespace terratact {

/// The open file of a SessionWriter: statements, hashes of the batch that is being written, and the last numbers.
/// Functions throw SqliteError.
struct SessionWriter::Impl {
    explicit Impl(std::string name, SqliteFile opened)
        : path(std::move(name)), file(std::move(opened)),
          version(file.integer("PRAGMA user_version")), frameTable(file, version, "can_frame"),
          modelTable(file, version, "model"), settingsTable(file, version, "settings"),
          sceneTable(file, version, "scene"), truthTable(file, version, "scene_truth"),
          estimateTable(file, version, "estimate"), binTable(file, version, "estimate_bin"),
          readingTable(file, version, "reading"), proposalTable(file, version, "proposal"),
          offerTable(file, version, "proposal_offer"), eventTable(file, version, "event"),
          drawsInsert(file.prepare("INSERT INTO estimate_draws VALUES(?, ?)")),
          batchInsert(file.prepare("INSERT INTO batch VALUES(?, ?, ?, ?, ?, ?, ?, ?)")),
          begin(file.prepare("BEGIN IMMEDIATE")), end(file.prepare("COMMIT"))
    {
    }

    /// Moves the journal into the file once it is large enough. A failure loses nothing: committed
    /// rows stay in the journal, and the next commit reports what is wrong with the disk.
    void checkpoint()
    {
        if (++journaledBatches < kCheckpointBatches && journaledBytes < kCheckpointBytes) return;
        journaledBatches = 0;
        journaledBytes = 0;
        try {
            file.checkpoint();
        } catch (const SqliteError&) {
        }
    }

    void start(SessionTime time)
    {
        if (time < -kMaxSessionTime || time > kMaxSessionTime)
            throw SqliteError(TR_NOOP(
                "core", "a row is more than 36 years from the session's begin, which no reader "
                        "accepts: split the recording, or correct its clock"));
        if (!open) {
            begin.run();
            open = true;
            batch.first = batch.last = time;
        }
        batch.first = std::min(batch.first, time);
        batch.last = std::max(batch.last, time);
    }
    template <class... Values>
    void row(SessionTableInsert& table, const Values&... values)
    {
        const std::string& bytes = table.insert(values...);
        journaledBytes += bytes.size();
        rows.add(table.index(), bytes);
    }
    std::int64_t settingsId(const Settings& settings);
    void addScene(const SceneRow& row);
    void addTruth(std::int64_t scene, ProbeSide side, const Heights& truth);
    void addEstimate(const EstimateRow& row);
    void addBins(std::int64_t estimate, std::string_view side, const TerrainEstimate& e);
    void addProposal(const ProposalRow& row);
    void addEvent(const EventRow& row);
    void commit();
    void goOn();  ///< continues after the rows in the file

    std::string path;
    SqliteFile file;
    std::int64_t version;  ///< of the file; only events are added to an older one
    SessionTableInsert frameTable, modelTable, settingsTable, sceneTable, truthTable, estimateTable,
        binTable, readingTable, proposalTable, offerTable, eventTable;
    SqliteStatement drawsInsert, batchInsert, begin, end;

    int journaledBatches = 0;        ///< since the last checkpoint
    std::size_t journaledBytes = 0;  ///< since the last checkpoint, approximate
    bool open = false;               ///< a transaction is open
    bool broken = false;
    bool ended = false;  ///< the file was opened again after its program had ended the session
    SessionBatch batch{.id = 1, .frameFirst = 1};
    Sha256 frameHash;
    RowsHash rows;
    std::string chain;
    std::optional<Settings> settings;
    std::int64_t settingsCount = 0, truthCount = 0, binCount = 0, readingCount = 0, offerCount = 0;
    std::int64_t lastModel = 0, lastScene = 0, lastEstimate = 0, lastProposal = 0, lastEvent = 0;
};

}  // namespace terratact
