#include "core/store/sqlite_statement.h"

#include <sqlite3.h>

#include "core/store/sqlite_error.h"

namespace terratact {
namespace {

/// Smallest size of a cell of a page (sqlite.org/fileformat2.html §1.6).
constexpr std::int64_t kMinCell = 6;

}  // namespace

void SqliteStatement::Finalise::operator()(sqlite3_stmt* statement) const
{
    sqlite3_finalize(statement);
}

void SqliteStatement::bind(int parameter, double value)
{
    checkSqlite(sqlite3_bind_double(statement_.get(), parameter + 1, value),
                sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::bind(int parameter, std::int64_t value)
{
    checkSqlite(sqlite3_bind_int64(statement_.get(), parameter + 1, value),
                sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::bind(int parameter, std::string_view value)
{
    checkSqlite(sqlite3_bind_text64(statement_.get(), parameter + 1, value.data(), value.size(),
                                    SQLITE_TRANSIENT, SQLITE_UTF8),
                sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::bind(int parameter, std::nullptr_t)
{
    checkSqlite(sqlite3_bind_null(statement_.get(), parameter + 1),
                sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::bindBlob(int parameter, std::string_view bytes)
{
    // A null pointer would bind NULL.
    checkSqlite(sqlite3_bind_blob64(statement_.get(), parameter + 1,
                                    bytes.empty() ? "" : bytes.data(), bytes.size(),
                                    SQLITE_TRANSIENT),
                sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::charge(std::int64_t bytes) const
{
    if (!bytesLeft_) return;
    *bytesLeft_ -= bytes;
    if (*bytesLeft_ < 0)
        throw SqliteError(
            TR_NOOP("core", "its rows hold more bytes than the file has: they share pages"));
}

bool SqliteStatement::step()
{
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) charge(kMinCell);
    if (code == SQLITE_ROW) return true;
    if (code != SQLITE_DONE) throw sqliteFailure(sqlite3_db_handle(statement_.get()));
    return false;
}

void SqliteStatement::run()
{
    while (step()) {
    }
    checkSqlite(sqlite3_reset(statement_.get()), sqlite3_db_handle(statement_.get()));
}

void SqliteStatement::expect(int column, int type) const
{
    if (this->type(column) == type) return;
    const char* const name = sqlite3_column_name(statement_.get(), column);
    throw SqliteError(
        Message(TR_NOOP("core", "a value of the wrong type in %1"), name ? name : "a column"));
}

double SqliteStatement::real(int column) const
{
    expect(column, SQLITE_FLOAT);
    return sqlite3_column_double(statement_.get(), column);
}

std::int64_t SqliteStatement::integer(int column) const
{
    expect(column, SQLITE_INTEGER);
    return sqlite3_column_int64(statement_.get(), column);
}

std::string SqliteStatement::bytes(int column) const
{
    const auto* const begin =
        static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    charge(size);
    return begin ? std::string(begin, static_cast<std::size_t>(size)) : std::string();
}

std::string SqliteStatement::text(int column) const
{
    expect(column, SQLITE_TEXT);
    return bytes(column);
}

std::string SqliteStatement::blob(int column) const
{
    expect(column, SQLITE_BLOB);
    return bytes(column);
}

int SqliteStatement::type(int column) const
{
    return sqlite3_column_type(statement_.get(), column);
}

bool SqliteStatement::isNull(int column) const
{
    return type(column) == SQLITE_NULL;
}

int SqliteStatement::columns() const
{
    return sqlite3_column_count(statement_.get());
}

}  // namespace terratact
