#pragma once

#include <utility>

#include "core/base/message.h"

struct sqlite3;

namespace terratact {

/// SQLite refused a step; the text is SQLite's. A caller that knows the file's name returns an
/// Error.
class SqliteError : public Failure {
public:
    explicit SqliteError(Message message, int code = 0) : Failure(std::move(message)), code_(code)
    {
    }
    int code() const { return code_; }  ///< errno where the system gave one, else 0

private:
    int code_;
};

/// Returns the last failure of `file` with SQLite's text. For a full disk a sentence says what to do. Usual texts can
/// be translated.
SqliteError sqliteFailure(sqlite3* file);

/// Throws sqliteFailure() unless the result code is SQLITE_OK.
void checkSqlite(int code, sqlite3* file);

}  // namespace terratact
