#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_tables.h"
#include "core/store/sqlite.h"

/// Valid hashes for rows that a test has changed, like those of a forger.
namespace terratact {

/// Recomputes the hash chain of a session.
inline void rehash(const std::string& path)
{
    SqliteFile db = SqliteFile::fill(path);
    std::map<std::int64_t, RowsHash> rows;
    RowBytes bytes;
    for (std::size_t table = 0; table < kSessionRowTables.size(); ++table) {
        SqliteStatement select = db.prepare(
            "SELECT * FROM " + std::string(kSessionRowTables.at(table)) + " ORDER BY id");
        while (select.step()) {
            bytes.clear();
            bytes.addRow(select, select.columns());
            rows[select.integer(1)].add(table, bytes.bytes());
        }
    }
    std::string chain = readSessionStart(db).hash;
    SqliteStatement select = db.prepare("SELECT * FROM batch ORDER BY id");
    SqliteStatement update =
        db.prepare("UPDATE batch SET frames_hash = ?, rows_hash = ?, chain = ? WHERE id = ?");
    while (select.step()) {
        const SessionBatch batch{.id = select.integer(0),
                                 .first = select.integer(1),
                                 .last = select.integer(2),
                                 .frameFirst = select.integer(3),
                                 .frameCount = select.integer(4)};
        Sha256 frames;
        SqliteStatement frame =
            db.prepare("SELECT * FROM can_frame WHERE seq >= ? AND seq < ? ORDER BY seq");
        frame.bind(0, batch.frameFirst);
        frame.bind(1, batch.frameFirst > 1000 ? 0 : batch.frameFirst + batch.frameCount % 1000);
        while (frame.step()) {
            bytes.clear();
            bytes.addRow(frame, frame.columns());
            frames.add(bytes.bytes());
        }
        const BatchHashes hashes{.frames = frames.finish(), .rows = rows[batch.id].finish()};
        chain = chained(chain, batch, hashes);
        update.bindBlob(0, hashes.frames);
        update.bindBlob(1, hashes.rows);
        update.bindBlob(2, chain);
        update.bind(3, batch.id);
        update.run();
    }
}

}  // namespace terratact
