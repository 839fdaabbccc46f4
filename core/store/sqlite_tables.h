#pragma once

#include <span>
#include <string>

#include "core/store/sqlite.h"

namespace terratact {

struct SqliteTable {
    std::string name;
    std::string sql;  ///< the statement that creates it
};

/// Returns true if a file has exactly these tables, created by exactly these statements. It has no
/// view, trigger or index. tables: sorted by name. Throws SqliteError.
bool hasOnlyTables(SqliteFile& file, std::span<const SqliteTable> tables);

}  // namespace terratact
