#pragma once

#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/store/sqlite.h"

namespace terratact {

/// Throws if the journal beside a session belongs to another session: SQLite would replace parts of
/// the main file with it. A session that is read with its own journal has the start and the last
/// batch of its main file. session: opened with the journal, now or before a live session grew. Does
/// nothing if the main file has no start yet. Disturbs no writer. A damaged journal is named as such:
/// what is read of it may be older than the main file.
void requireOwnJournal(const std::string& path, SqliteFile& session);

/// Returns true if requireOwnJournal() finds another session's journal.
bool hasForeignJournal(const std::string& path);

/// Returns a sentence about the damage of the journal beside a session in WAL mode. It states how
/// much of the journal is not read (core/store/sqlite_journal.h). Empty: it is whole, empty or
/// missing.
std::optional<Message> damageOfJournal(const std::string& path);

}  // namespace terratact
