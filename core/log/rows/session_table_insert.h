#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/text.h"
#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_schema.h"
#include "core/log/rows/session_tables.h"
#include "core/store/sqlite.h"

namespace terratact {

/// Bytes of a BLOB column.
struct Blob {
    std::string_view bytes;
};

/// Inserts rows of one table of a session and returns the bytes that their hash covers.
class SessionTableInsert {
public:
    SessionTableInsert(SqliteFile& file, std::int64_t version, std::string_view name)
        : insert_(prepare(file, name, sessionColumns(version, name)))
    {
        for (; index_ < kSessionRowTables.size() && kSessionRowTables.at(index_) != name;
             ++index_) {
        }
    }

    template <class... Values>
    const std::string& insert(const Values&... values)
    {
        bytes_.clear();
        int column = 0;
        (putNext(column, values), ...);
        insert_.run();
        return bytes_.bytes();
    }
    std::size_t index() const { return index_; }

private:
    static SqliteStatement prepare(SqliteFile& file, std::string_view name, int columns)
    {
        std::string sql = "INSERT INTO " + std::string(name) + " VALUES(?";
        for (int i = 1; i < columns; ++i) sql += ", ?";
        return file.prepare(sql + ")");
    }
    template <class Value>
    void putNext(int& column, const Value& value)
    {
        put(column++, value);
    }
    /// Puts the elements into as many columns.
    template <class Value, std::size_t N>
    void putNext(int& column, const std::array<Value, N>& values)
    {
        for (const Value& value : values) put(column++, value);
    }
    template <class Value>
    void put(int column, const Value& value)
    {
        insert_.bind(column, value);
        bytes_.add(value);
    }
    void put(int column, const std::string& value)
    {
        put(column, beginningOf(value, kMaxTextBytes));
    }
    template <class Value>
    void put(int column, const std::optional<Value>& value)
    {
        if (value) return put(column, *value);
        insert_.bind(column, nullptr);
        bytes_.addNull();
    }
    void put(int column, const Blob& value)
    {
        insert_.bindBlob(column, value.bytes);
        bytes_.addBlob(value.bytes);
    }

    SqliteStatement insert_;
    std::size_t index_ = 0;
    RowBytes bytes_;
};

}  // namespace terratact
