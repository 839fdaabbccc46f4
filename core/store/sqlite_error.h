#pragma once

#include "core/base/message.h"

struct sqlite3;

namespace terratact {

/// SQLite refused a step; the text is SQLite's. A caller that knows the file's name returns an
/// Error.
class SqliteError : public Failure {
public:
    using Failure::Failure;
};

/// Returns SQLite's text of the last failure of `file`; for a full disk, a sentence that says what to
/// do. Usual texts can be translated.
Message sqliteMessage(sqlite3* file);

/// Throws SqliteError with sqliteMessage() unless the result code is SQLITE_OK.
void checkSqlite(int code, sqlite3* file);

}  // namespace terratact
