#include "core/log/rows/session_hash.h"

#include <sqlite3.h>

namespace terratact {

void RowBytes::add(std::int64_t value)
{
    bytes_.add(std::uint64_t{SQLITE_INTEGER});
    bytes_.add(static_cast<std::uint64_t>(value));
}

void RowBytes::add(double value)
{
    bytes_.add(std::uint64_t{SQLITE_FLOAT});
    bytes_.add(value);
}

void RowBytes::add(std::string_view value)
{
    bytes_.add(std::uint64_t{SQLITE_TEXT});
    bytes_.add(value);
}

void RowBytes::addBlob(std::string_view value)
{
    bytes_.add(std::uint64_t{SQLITE_BLOB});
    bytes_.add(value);
}

void RowBytes::addNull()
{
    bytes_.add(std::uint64_t{SQLITE_NULL});
}

void RowBytes::addRow(const SqliteStatement& row, int columns)
{
    for (int i = 0; i < columns; ++i) {
        switch (row.type(i)) {
        case SQLITE_INTEGER: add(row.integer(i)); break;
        case SQLITE_FLOAT: add(row.real(i)); break;
        case SQLITE_TEXT: add(std::string_view(row.text(i))); break;
        case SQLITE_BLOB: addBlob(row.blob(i)); break;
        default: addNull();
        }
    }
}

std::string RowsHash::finish()
{
    Sha256 all;
    for (Sha256& table : tables_) all.add(table.finish());
    return all.finish();
}

std::string chained(std::string_view before, const SessionBatch& batch, const BatchHashes& hashes)
{
    RowBytes bytes;
    bytes.addBlob(before);
    for (const std::int64_t value :
         {batch.id, batch.first, batch.last, batch.frameFirst, batch.frameCount})
        bytes.add(value);
    bytes.addBlob(hashes.frames);
    bytes.addBlob(hashes.rows);
    Sha256 hash;
    hash.add(bytes.bytes());
    return hash.finish();
}

}  // namespace terratact
