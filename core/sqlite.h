#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace terratact {

/// SQLite refused a step: its own words.  Whoever knows the file's name catches it and returns an Error.
class SqliteError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A prepared statement.  Parameters and columns count from 0.
class SqliteStatement {
public:
    void bind(int parameter, double value);
    void bind(int parameter, std::int64_t value);
    void bind(int parameter, std::string_view value);
    void bind(int parameter, const char* value) { bind(parameter, std::string_view(value)); }
    void bind(int parameter, int value) { bind(parameter, std::int64_t{value}); }

    /// Goes to the next row; false after the last.
    bool step();
    /// Executes a statement without rows; it can then be bound anew.
    void run();

    /// Columns of the present row.  Throw SqliteError where the column holds another type.
    double real(int column) const;
    std::int64_t integer(int column) const;
    std::string text(int column) const;

private:
    friend class SqliteFile;
    struct Finalise {
        void operator()(sqlite3_stmt* statement) const;
    };
    explicit SqliteStatement(sqlite3_stmt* statement) : statement_(statement) {}
    void expect(int column, int type) const;

    std::unique_ptr<sqlite3_stmt, Finalise> statement_;
};

/// An SQLite file.  Every failure is a SqliteError.  Not to be shared between threads.
class SqliteFile {
public:
    /// Opens a finished file that may come from anyone, for reading: it has the size its header says,
    /// its structure has been checked, nothing in it is executed or trusted, no journal beside it is
    /// looked at, and all statements together end after a bounded number of steps.
    /// Refuses a file of more than `most` bytes.
    static SqliteFile openUntrusted(const std::string& path, std::uintmax_t most);

    /// Opens an empty file to be filled and then renamed (core/file_write.h): no journal, no flushing.
    static SqliteFile fill(const std::string& path);

    SqliteStatement prepare(std::string_view sql);
    void run(std::string_view sql) { prepare(sql).run(); }

    /// The one integer that a query yields.
    std::int64_t integer(std::string_view sql);

    /// Closes; throws where something could not be written.
    void close();

private:
    struct Close {
        void operator()(sqlite3* file) const;
    };
    SqliteFile(const std::string& name, int flags);
    void harden();
    void checkStructure();

    std::unique_ptr<int> callsLeft_;  ///< of the progress handler
    std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace terratact
