#pragma once

#include <cstddef>
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
    void bind(int parameter, std::nullptr_t);
    void bindBlob(int parameter, std::string_view bytes);

    /// Goes to the next row; false after the last.
    bool step();
    /// Executes a statement without rows; it can then be bound anew.
    void run();

    /// Columns of the present row.  Throw SqliteError where the column holds another type.
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
    explicit SqliteStatement(sqlite3_stmt* statement) : statement_(statement) {}
    void expect(int column, int type) const;
    std::string bytes(int column) const;

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

    /// Likewise, but of any size, for a format that checks its rows itself: the structure is not checked as a
    /// whole, which takes minutes for gigabytes.  A file in WAL mode, which somebody still writes or whose
    /// writer died, is read with the journal beside it.  Texts and blobs are at most `longest` bytes.
    static SqliteFile openLog(const std::string& path, int longest);

    /// Whether the file is in WAL mode: not closed by its writer.  Throws as openLog where it is no SQLite file.
    static bool isJournaled(const std::string& path);

    /// Creates a file, which must not exist, to be written by one connection while others read it: with a
    /// write-ahead journal (WAL), flushed to the disk with every commit.
    static SqliteFile createLog(const std::string& path);

    /// Opens such a file whose writer died to go on with it; its journal is played back.
    static SqliteFile reopenLog(const std::string& path);

    /// Moves the journal into the file and leaves WAL mode; false, and nothing happens, while somebody else has it
    /// open.
    bool leaveJournal();

    /// Statements of an untrusted file may take as many steps again from now on.
    void grantSteps();

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
    void journal();

    std::unique_ptr<int> callsLeft_;  ///< of the progress handler
    std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace terratact
