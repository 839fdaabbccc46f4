#include <filesystem>
#include <system_error>
#include <utility>

#include "core/log/rows/session_tables.h"
#include "core/log/session_journal.h"
#include "core/log/session_writer.h"
#include "core/store/file_read.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

bool isLink(const std::string& path)
{
    std::error_code none;
    return std::filesystem::is_symlink(path, none);
}

}  // namespace

Result<SessionRecovery> recoverSession(const std::string& path, bool evenAlone)
{
    const bool linked = isLink(path) || isLink(path + "-wal") || isLink(path + "-shm");
    if (linked)
        return fileError(
            path,
            isLink(path) ? TR_NOOP("core", "is a symbolic link: name the file itself")
                         : TR_NOOP("core", "its journal is a symbolic link, which is not followed"),
            kNotFollowed);
    try {
        if (!SqliteFile::isJournaled(path)) return SessionRecovery::NotNeeded;
        if (!evenAlone && SqliteFile::lacksJournal(path))
            return fileError(
                path, TR_NOOP("core", "its journal is not beside it: both files belong together"));
        if (const auto damage = damageOfJournal(path)) return fileError(path, *damage);
        SqliteFile::requireReadableJournal(path);
        SqliteFile file = SqliteFile::reopenLog(path);
        requireSessionSchema(file);
        requireOwnJournal(path, file);
        if (!file.leaveJournal()) return SessionRecovery::InUse;
        SqliteFile alone = SqliteFile::reopenLog(path);
        return SessionWriter::finish(path, std::move(alone));
    } catch (const SqliteError& error) {
        return fileError(path, error.message());
    }
}

}  // namespace terratact
