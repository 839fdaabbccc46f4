#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "tests/fuzz/promise.h"

namespace terratact::fuzz {

/// Reads bytes in sequence; zeros after the last.
struct FuzzBytes {
    const std::uint8_t* data;
    std::size_t left;

    std::uint8_t next()
    {
        if (left == 0) return 0;
        --left;
        return *data++;
    }
    template <class Number>
    Number number()
    {
        Number value{};
        std::uint8_t bytes[sizeof value];
        for (std::uint8_t& byte : bytes) byte = next();
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }
    std::string text()
    {
        std::string value(next() % 64, '\0');
        for (char& c : value) c = static_cast<char>(next());
        return value;
    }
};

/// Writes one value into a column of one row. A value that SQLite rejects, such as a wrong type, changes nothing.
inline void put(sqlite3* db, const std::string& table, FuzzBytes& bytes)
{
    sqlite3_stmt* columns = nullptr;
    const std::string all = "SELECT * FROM " + table;
    if (sqlite3_prepare_v2(db, all.c_str(), -1, &columns, nullptr) != SQLITE_OK) return;
    const int column = bytes.next() % sqlite3_column_count(columns);
    const std::string name = sqlite3_column_name(columns, column);
    sqlite3_finalize(columns);
    const std::string sql = "UPDATE OR IGNORE " + table + " SET " + name + " = ? WHERE rowid = ?";
    sqlite3_stmt* update = nullptr;
    if (sqlite3_prepare_v2(db, sql.c_str(), -1, &update, nullptr) != SQLITE_OK) return;
    const std::uint8_t type = bytes.next() % 4;
    const std::int64_t row = 1 + bytes.next() % 24;
    if (type == 0) sqlite3_bind_int64(update, 1, bytes.number<std::int64_t>());
    if (type == 1) sqlite3_bind_double(update, 1, bytes.number<double>());
    if (type == 2) {
        const std::string value = bytes.text();
        sqlite3_bind_text(update, 1, value.data(), static_cast<int>(value.size()),
                          SQLITE_TRANSIENT);
    }
    if (type == 3) {
        const std::string value = bytes.text();
        sqlite3_bind_blob(update, 1, value.data(), static_cast<int>(value.size()),
                          SQLITE_TRANSIENT);
    }
    sqlite3_bind_int64(update, 2, row);
    sqlite3_step(update);
    sqlite3_finalize(update);
}

/// Opens a database for put(), without a journal.
inline sqlite3* openRows(const std::string& path)
{
    sqlite3* db = nullptr;
    promise(sqlite3_open(path.c_str(), &db) == SQLITE_OK, "the database can be opened");
    sqlite3_exec(db, "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF", nullptr, nullptr,
                 nullptr);
    return db;
}

}  // namespace terratact::fuzz
