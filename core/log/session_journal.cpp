#include "core/log/session_journal.h"

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/text.h"
#include "core/log/rows/session_tables.h"
#include "core/store/sqlite_journal.h"

namespace terratact {
namespace {

constexpr int kMaxStartValue = 1 << 20;  // bytes of one value

/// The start and the last batch of a session.
struct SessionEnds {
    std::string start;       ///< hash
    std::int64_t batch = 0;  ///< 0: none
    std::string chain{};     ///< link of that batch
};

/// Returns the ends of the main file alone; empty: it has no start.
std::optional<SessionEnds> endsWithoutJournal(const std::string& path)
{
    try {
        SqliteFile alone = SqliteFile::openLogWithoutJournal(path, kMaxStartValue);
        SessionEnds ends{.start = readSessionStart(alone).hash};
        SqliteStatement last =
            alone.prepare("SELECT id, chain FROM batch ORDER BY id DESC LIMIT 1");
        if (last.step()) {
            ends.batch = last.integer(0);
            ends.chain = last.blob(1);
        }
        return ends;
    } catch (const Failure&) {
        return std::nullopt;
    }
}

/// alone: read before the session was opened, or a live session may have grown in between.
bool isOfAnother(const SessionEnds& alone, SqliteFile& session)
{
    if (readSessionStart(session).hash != alone.start) return true;
    if (alone.batch == 0) return false;
    SqliteStatement same = session.prepare("SELECT chain FROM batch WHERE id = ?");
    same.bind(0, alone.batch);
    return !same.step() || same.blob(0) != alone.chain;
}

/// Returns the name of its journal without the folder.
std::string journalNameOf(const std::string& path)
{
    return printable(std::filesystem::path(SqliteFile::journalOf(path)).filename().string());
}

}  // namespace

void requireOwnJournal(const std::string& path, SqliteFile& session)
{
    const auto alone = endsWithoutJournal(path);
    if (!alone || !isOfAnother(*alone, session)) return;
    if (const auto damage = damageOfJournal(path)) throw SqliteError(*damage);
    if (!hasForeignJournal(path)) return;
    throw SqliteError(
        Message(TR_NOOP("core", "its journal %1 was written for another session: move it away"),
                journalNameOf(path)));
}

bool hasForeignJournal(const std::string& path)
{
    try {
        const auto alone = endsWithoutJournal(path);
        if (!alone) return false;
        SqliteFile file = SqliteFile::openLogWithoutTrace(path, kMaxStartValue);
        return file.readsJournal() && isOfAnother(*alone, file);
    } catch (const Failure&) {
        return false;
    }
}

std::optional<Message> damageOfJournal(const std::string& path)
{
    const auto damage = journalDamage(SqliteFile::journalOf(path));
    if (!damage) return std::nullopt;
    if (damage->at == 0)
        return Message(TR_NOOP("core", "its journal %1 is damaged from its beginning: what was "
                                       "recorded after that was in there"),
                       journalNameOf(path));
    return Message(TR_NOOP("core", "its journal %1 is damaged from byte %2: %3 pages in it are "
                                   "not read"),
                   journalNameOf(path), damage->at, damage->frames);
}

}  // namespace terratact
