#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3_stmt;

namespace terratact {

/// A prepared statement.  Parameters and columns count from 0.
class SqliteStatement {
public:
    void bind(int parameter, double value);
    void bind(int parameter, std::int64_t value);
    void bind(int parameter, std::string_view value);
    void bind(int parameter, const char* value) { bind(parameter, std::string_view(value)); }
    void bind(int parameter, int value) { bind(parameter, std::int64_t{value}); }
    void bind(int parameter, std::nullptr_t);
    void bindBlob(int parameter, std::string_view bytes);

    /// Goes to the next row; false after the last.
    bool step();
    /// Executes a statement without rows; new values can then be bound.
    void run();

    /// Return columns of the current row. Throw SqliteError if the column holds another type.
    double real(int column) const;
    std::int64_t integer(int column) const;
    std::string text(int column) const;
    std::string blob(int column) const;
    bool isNull(int column) const;
    int type(int column) const;  ///< SQLITE_INTEGER and so on
    int columns() const;

private:
    friend class SqliteFile;
    struct Finalise {
        void operator()(sqlite3_stmt* statement) const;
    };
    SqliteStatement(sqlite3_stmt* statement, std::int64_t* bytesLeft)
        : statement_(statement), bytesLeft_(bytesLeft)
    {
    }
    void expect(int column, int type) const;
    void charge(std::int64_t bytes) const;
    std::string bytes(int column) const;

    std::unique_ptr<sqlite3_stmt, Finalise> statement_;
    /// Bytes left for the file, see SqliteFile::grantPasses(); null: no limit.
    std::int64_t* bytesLeft_;
};

}  // namespace terratact
