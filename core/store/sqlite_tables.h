#pragma once

#include <span>
#include <string>

#include "core/store/sqlite.h"

namespace terratact {

struct SqliteTable {
    std::string name;
    std::string sql;  ///< that makes it
};

/// Whether a file has exactly these tables, made by exactly these words, and nothing else: no view, trigger or index.
/// tables: sorted by name.  Throws SqliteError.
bool hasOnlyTables(SqliteFile& file, std::span<const SqliteTable> tables);

}  // namespace terratact
