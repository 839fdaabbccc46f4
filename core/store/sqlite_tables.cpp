#include "core/store/sqlite_tables.h"

namespace terratact {

bool hasOnlyTables(SqliteFile& file, std::span<const SqliteTable> tables)
{
    SqliteStatement found =
        file.prepare("SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY name");
    for (const SqliteTable& table : tables) {
        if (!found.step()) return false;
        if (found.text(0) != "table" || found.text(1) != table.name || found.text(2) != table.name
            || found.text(3) != table.sql)
            return false;
    }
    return !found.step();
}

}  // namespace terratact
