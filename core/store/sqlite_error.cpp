#include "core/store/sqlite_error.h"

#include <sqlite3.h>

#include <array>
#include <string>
#include <string_view>

#include "core/base/system_message.h"

namespace terratact {
namespace {

/// Returns errno of a file that the system did not open, read or write; else 0.
int systemCode(sqlite3* file)
{
    const int code = sqlite3_errcode(file) & 0xFF;  // without the extension
    return code == SQLITE_IOERR || code == SQLITE_CANTOPEN ? sqlite3_system_errno(file) : 0;
}

Message sqliteMessage(sqlite3* file)
{
    static constexpr std::array kUsual{
        TR_NOOP("core", "database disk image is malformed"),
        TR_NOOP("core", "file is not a database"),
        TR_NOOP("core", "database is locked"),
        TR_NOOP("core", "disk I/O error"),
        TR_NOOP("core", "unable to open database file"),
        TR_NOOP("core", "attempt to write a readonly database"),
        TR_NOOP("core", "string or blob too big"),
        TR_NOOP("core", "SQL logic error"),
        TR_NOOP("core", "out of memory"),
    };
    constexpr std::string_view kSchema = "malformed database schema (";
    const std::string said = sqlite3_errmsg(file);
    if (sqlite3_errcode(file) == SQLITE_FULL)
        return TR_NOOP("core",
                       "the disk is full: free space on it, or name a file on another disk");
    if (const int cause = systemCode(file); cause != 0)
        return {TR_NOOP("core", "the file system refuses it: %1"), systemMessage(cause)};
    if (sqlite3_errcode(file) == SQLITE_INTERRUPT)
        return TR_NOOP("core", "its tables take more steps to read than a file of its size needs");
    if (sqlite3_extended_errcode(file) == SQLITE_IOERR_WRITE)
        return TR_NOOP(
            "core",
            "cannot be written: is the disk full, or the file larger than ulimit -f allows?");
    for (const SourceText& usual : kUsual)
        if (said == usual.english) return usual;
    if (said.starts_with(kSchema))
        return {TR_NOOP("core", "malformed database schema %1"), said.substr(kSchema.size() - 1)};
    return Message::verbatim(said);
}

}  // namespace

SqliteError sqliteFailure(sqlite3* file)
{
    return SqliteError(sqliteMessage(file), systemCode(file));
}

void checkSqlite(int code, sqlite3* file)
{
    if (code != SQLITE_OK) throw sqliteFailure(file);
}

}  // namespace terratact
