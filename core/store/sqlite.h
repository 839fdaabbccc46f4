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
    SqliteStatement(sqlite3_stmt* statement, std::int64_t* bytesLeft)
        : statement_(statement), bytesLeft_(bytesLeft)
    {
    }
    void expect(int column, int type) const;
    void take(std::int64_t bytes) const;
    std::string bytes(int column) const;

    std::unique_ptr<sqlite3_stmt, Finalise> statement_;
    std::int64_t* bytesLeft_;  ///< of the file's, see SqliteFile::grantBytes(); null: no bound
};

/// An SQLite file.  Every failure is a SqliteError.  Not to be shared between threads.
class SqliteFile {
public:
    /// Opens a finished file that may come from anyone, for reading: it has the size its header says,
    /// its structure has been checked, nothing in it is executed or trusted, no journal beside it is
    /// looked at, and all statements together end after a bounded number of steps.
    /// Refuses a file of more than `most` bytes.
    static SqliteFile openUntrusted(const std::string& path, std::uintmax_t most);

    /// Opens a file of any size, for a format that checks its rows itself: its structure is checked when
    /// structureFault() is asked.  A file in WAL mode, which somebody still writes or whose writer died, is read
    /// with the journal beside it, also where neither the file nor its folder can be written; without one, as it
    /// is.  Texts and blobs are at most `longest` bytes, and all values together are bounded: grantBytes().
    static SqliteFile openLog(const std::string& path, int longest);

    /// Whether the file is in WAL mode: not closed by its writer.  Throws as openLog where it is no SQLite file.
    static bool isJournaled(const std::string& path);

    /// Whether the journal that belongs to a file in WAL mode is not beside it.
    static bool lacksJournal(const std::string& path);

    /// Whether the journal beside a file in WAL mode holds bytes that are none of a journal, so that nothing of it can
    /// be read.
    static bool journalIsDamaged(const std::string& path);

    /// Creates a file, which must not exist, to be written by one connection while others read it: with a
    /// write-ahead journal (WAL), flushed to the disk with every commit.  Only its owner can read it (mode 0600).
    static SqliteFile createLog(const std::string& path);

    /// Opens such a file whose writer died to go on with it; its journal is played back.
    static SqliteFile reopenLog(const std::string& path);

    /// Moves what the journal holds into the file, as far as no reader still needs the older state.
    void checkpoint();

    /// What is wrong with the structure: pages that two rows share, lost pages, broken cells.  Empty: nothing.
    /// Takes 4 s for a gigabyte.
    std::string structureFault();

    /// Moves the journal into the file and leaves WAL mode; false, and nothing happens, while somebody else has it
    /// open.
    bool leaveJournal();

    /// Statements of an untrusted file may take as many steps again from now on.
    void grantSteps();

    /// From now on a log's rows may yield `times` as many bytes of values as the file and its journal have.  Rows
    /// that share pages can hold far more than the file; then a SqliteError says so.
    void grantBytes(int times);

    /// Bytes of a log and its journal when grantBytes() was last called.
    std::int64_t size() const { return size_; }

    /// Creates an empty file, which must not exist, for its owner alone to read and write (mode 0600).
    static void makeEmpty(const std::string& path);

    /// Opens an empty file to be filled and then renamed (core/store/file_write.h): no journal, no flushing.
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
    bool isReadable();

    std::string path_;                         ///< of a log that is read
    std::int64_t size_ = 0;                    ///< likewise [bytes]
    std::unique_ptr<int> callsLeft_;           ///< of the progress handler
    std::unique_ptr<std::int64_t> bytesLeft_;  ///< that rows may yield; null: no bound
    std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace terratact
