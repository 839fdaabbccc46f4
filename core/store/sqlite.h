#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "core/store/sqlite_error.h"
#include "core/store/sqlite_statement.h"

struct sqlite3;

namespace terratact {

/// SQLite file. Every failure throws SqliteError. One thread at a time may use it.
class SqliteFile {
public:
    /// Opens a finished file from an untrusted source for reading. Its size must match its header,
    /// and its structure is checked. Nothing in it is executed or trusted, and a journal beside it
    /// is ignored. All statements together end after a bounded number of steps. Refuses a file of
    /// more than `most` bytes.
    static SqliteFile openUntrusted(const std::string& path, std::uintmax_t most);

    /// Opens a file of any size, for a format that checks its rows itself; structureFault() checks
    /// the structure on request. A file in WAL mode is still being written, or its writer died. It is read with the
    /// journal beside it, if there is one, even from a write-protected folder. It is read up to the first damaged frame
    /// of the journal (core/store/sqlite_journal.h). No file is left beside it. As long as it is open, leaveJournal()
    /// of other objects does nothing. It is not locked where its index cannot be read, or is beside a journal with a
    /// damaged header. Texts and blobs have at most `longest` bytes, and grantPasses() bounds all values and steps
    /// together: one pass, until it is called.
    static SqliteFile openLog(const std::string& path, int longest);

    /// Opens a log as openLog(), but disturbs no writer, not even one of this process. A file with
    /// a journal beside it is opened by SQLite alone: closing any other descriptor would release
    /// this process's locks on it.
    static SqliteFile openLogWithoutTrace(const std::string& path, int longest);

    /// Opens a log as openLog(), but ignores its journal.
    static SqliteFile openLogWithoutJournal(const std::string& path, int longest);

    /// Returns true if the connection reads in WAL mode, with a journal.
    bool readsJournal();

    /// Returns true if the file is in WAL mode: its writer did not close it. Throws as openLog if
    /// it is no SQLite file.
    static bool isJournaled(const std::string& path);

    /// Returns the path of a file's journal, existing or not: beside the file that a link means.
    static std::string journalOf(const std::string& path);

    /// Returns true if the journal of a file in WAL mode is missing or empty.
    static bool lacksJournal(const std::string& path);

    /// Throws if the journal beside a file cannot be read: it is a link, no file, or not permitted.
    static void requireReadableJournal(const std::string& path);

    /// Creates a file that one connection writes while others read. It must not exist. It has a
    /// write-ahead journal (WAL) that every commit flushes to the disk. Only its owner can read it
    /// (mode 0600).
    static SqliteFile createLog(const std::string& path);

    /// Reopens such a file after its writer died; its journal is replayed.
    static SqliteFile reopenLog(const std::string& path);

    /// Moves the part of the journal into the file that no reader needs in its older state.
    void checkpoint();

    /// Returns the structural fault of the file: pages that two rows share, lost pages, broken
    /// cells. Empty: none. It takes 4 s for a gigabyte.
    std::string structureFault();

    /// Moves the journal into the file and leaves WAL mode. Returns false and does nothing while
    /// another process has the file open.
    bool leaveJournal();

    /// Restarts the count of steps that limits the statements of a file of openUntrusted().
    void grantSteps();

    /// Limits all further statements of a log to `times` passes over file and journal. A pass returns
    /// as many bytes as they have, and takes a step for each of these bytes. 10 million further steps
    /// are allowed. Beyond that a SqliteError is thrown: rows that share pages could return far more
    /// than the file holds. SQLite executes `SELECT count(*) FROM table` in a single step, which no
    /// limit ends. Step through the rows instead.
    void grantPasses(int times);

    /// Returns the bytes of a log and its journal at the last call of grantPasses().
    std::int64_t size() const { return size_; }

    /// Creates an empty file for its owner only (mode 0600). Neither it nor a file that SQLite would
    /// take for its journal may exist.
    static void makeEmpty(const std::string& path);

    /// Opens an empty file to fill it and then rename it (core/store/file_write.h): no journal, no
    /// flushing.
    static SqliteFile fill(const std::string& path);

    SqliteStatement prepare(std::string_view sql);
    void run(std::string_view sql) { prepare(sql).run(); }

    /// Returns the single integer of a query.
    std::int64_t integer(std::string_view sql);

    /// Closes the file. Throws if something could not be written.
    void close();

private:
    static void requireNothingBeside(const std::string& path);
    struct Close {
        void operator()(sqlite3* file) const;
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    using Lock = std::unique_ptr<std::FILE, Close>;
    SqliteFile(const std::string& name, int flags);
    static SqliteFile readLog(const std::string& path, int longest, std::string_view options);
    static SqliteFile readLogAlone(const std::string& path, int longest);
    static SqliteFile readJournaled(const std::string& path, int longest, std::string_view options);
    static Lock readerLock(const std::string& path);
    void harden();
    void checkStructure();
    void journal();
    bool isReadable();

    std::string path_;                         ///< path of a log that is read
    std::int64_t size_ = 0;                    ///< size of a log that is read [bytes]
    std::unique_ptr<std::int64_t> callsLeft_;  ///< remaining calls of the progress handler
    std::unique_ptr<std::int64_t> bytesLeft_;  ///< bytes that rows may still return; null: no limit
    Lock lock_;                                ///< of a log that is read without SQLite's locks
    std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace terratact
