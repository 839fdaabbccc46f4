#include "core/store/sqlite.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include "core/base/system_message.h"
#include "core/base/text.h"
#include "core/store/sqlite_error.h"
#include "core/store/sqlite_journal.h"

namespace terratact {
namespace {

/// Returns a path as an SQLite URI, with all but plain characters percent-encoded.
std::string uriOf(const std::string& path, std::string_view options)
{
    constexpr std::string_view kHex = "0123456789ABCDEF";
    constexpr std::string_view kPlain = "/._-";
    std::string uri = path.starts_with('/') ? "file://" : "file:";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z')
                        || (c >= 'a' && c <= 'z') || kPlain.find(c) != std::string_view::npos;
        if (plain)
            uri += c;
        else
            uri.append({'%', kHex[byte >> 4U], kHex[byte & 15U]});
    }
    return uri.append("?").append(options);
}

/// Returns the path of a file that SQLite keeps beside another: beside the file that a link means.
std::string besideFile(const std::string& path, std::string_view ending)
{
    std::error_code none;
    const std::filesystem::path target = std::filesystem::canonical(path, none);
    return std::string(none ? path : target.string()).append(ending);
}

/// Returns the big-endian number of `bytes` bytes.
std::uint64_t bigEndian(const char* at, int bytes)
{
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8U | static_cast<unsigned char>(at[i]);
    return value;
}

constexpr std::string_view kMagic("SQLite format 3\0", 16);

/// Refuses a directory, and a pipe or a device, whose reader would wait. It opens nothing.
void requireFile(const std::string& path)
{
    std::error_code unknown;
    const std::filesystem::file_status there = std::filesystem::status(path, unknown);
    if (std::filesystem::is_directory(there)) throw SqliteError(TR_NOOP("core", "is a directory"));
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        throw SqliteError(TR_NOOP("core", "it is not a regular file, and an SQLite file is read "
                                          "back and forth: save it as a file first"));
}

/// The first 100 bytes of the file.
using Header = std::array<char, 100>;
Header headerOf(const std::string& path)
{
    requireFile(path);
    Header header{};
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        const int code = errno;
        throw SqliteError(Message(TR_NOOP("core", "cannot be opened: %1"), systemMessage(code)),
                          code);
    }
    in.read(header.data(), header.size());
    if (in.gcount() == 0) throw SqliteError(TR_NOOP("core", "is empty: copy it again"));
    if (!in || std::string_view(header.data(), kMagic.size()) != kMagic)
        throw SqliteError(TR_NOOP("core", "is not an SQLite file"));
    return header;
}

/// Refuses a file that is no SQLite file, or whose length differs from its header
/// (sqlite.org/fileformat2.html §1.3).
void checkSize(const std::string& path, std::uintmax_t most)
{
    std::error_code none;
    const Header header = headerOf(path);
    const std::uint64_t page = bigEndian(&header[16], 2);
    const std::uint64_t expected = (page == 1 ? 65536 : page) * bigEndian(&header[28], 4);
    const std::uintmax_t size = std::filesystem::file_size(path, none);
    if (none)
        throw SqliteError(Message(TR_NOOP("core", "has no size: %1"), systemMessage(none.value())));
    if (size > most)
        throw SqliteError(Message(TR_NOOP("core", "is larger than the %1 bytes allowed"), most));
    if (size == expected) return;
    const SourceText text =
        size < expected ? TR_NOOP(
            "core", "has %1 bytes where its header says %2: it is truncated, copy it again")
                        : TR_NOOP("core", "has %1 bytes where its header says %2");
    throw SqliteError(Message(text, size, expected));
}

}  // namespace

void SqliteFile::Close::operator()(sqlite3* file) const
{
    sqlite3_close_v2(file);
}

SqliteFile::SqliteFile(const std::string& name, int flags)
{
    sqlite3* file = nullptr;
    const int code = sqlite3_open_v2(
        name.c_str(), &file, flags | SQLITE_OPEN_PRIVATECACHE | SQLITE_OPEN_NOMUTEX, nullptr);
    file_.reset(file);
    if (!file) throw SqliteError(TR_NOOP("core", "out of memory"));
    checkSqlite(code, file);
}

SqliteFile SqliteFile::openUntrusted(const std::string& path, std::uintmax_t most)
{
    checkSize(path, most);
    SqliteFile file(uriOf(path, "mode=ro&immutable=1"), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    file.harden();
    file.checkStructure();
    return file;
}

bool SqliteFile::isJournaled(const std::string& path)
{
    return headerOf(path)[18] == 2;  // write version of the file format
}

std::string SqliteFile::journalOf(const std::string& path)
{
    return besideFile(path, "-wal");
}

bool SqliteFile::lacksJournal(const std::string& path)
{
    const std::string journal = journalOf(path);
    std::error_code none;
    if (!std::filesystem::exists(std::filesystem::symlink_status(journal, none)))
        return isJournaled(path);
    const bool isEmpty = std::filesystem::is_regular_file(journal, none)
                      && std::filesystem::file_size(journal, none) == 0;
    return isEmpty && isJournaled(path);
}

/// Returns false if SQLite may not open or write the index beside the file. Throws for any other
/// failure.
bool SqliteFile::isReadable()
{
    try {
        static_cast<void>(integer("PRAGMA schema_version"));
        return true;
    } catch (const SqliteError&) {
        const int code = sqlite3_errcode(file_.get()) & 0xFF;
        if (code != SQLITE_CANTOPEN && code != SQLITE_READONLY && code != SQLITE_IOERR) throw;
        return false;
    }
}

// SQLite would report that it cannot open the file.
void SqliteFile::requireReadableJournal(const std::string& path)
{
    const std::filesystem::path journal = journalOf(path);
    std::error_code none;
    if (std::filesystem::is_symlink(journal, none))
        throw SqliteError(TR_NOOP("core", "its journal is a symbolic link, which is not followed"));
    if (!std::filesystem::exists(journal, none)) return;  // its writer has just closed it
    const bool isFile = std::filesystem::is_regular_file(journal, none);
    if (isFile && ::access(journal.c_str(), R_OK) == 0) return;
    const int code = errno;
    const std::string name = printable(journal.filename().string());
    if (!isFile)
        throw SqliteError(Message(
            TR_NOOP("core", "its journal %1 is not a file; both files belong together"), name));
    throw SqliteError(
        Message(TR_NOOP("core", "its journal %1 cannot be read: %2; both files belong together"),
                name, systemMessage(code)));
}

SqliteFile SqliteFile::readLog(const std::string& path, int longest, std::string_view options)
{
    SqliteFile file(uriOf(path, options), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    file.path_ = path;
    file.harden();
    sqlite3_limit(file.file_.get(), SQLITE_LIMIT_LENGTH, longest);
    sqlite3_busy_timeout(file.file_.get(), 200);  // [ms] for a checkpoint of the writer
    file.bytesLeft_ = std::make_unique<std::int64_t>(0);
    file.grantPasses(1);
    return file;
}

/// Opens a file whose journal's index SQLite cannot or must not create beside it. SQLite can hold the
/// index in memory for a single reader. That needs a lock and the right to write, so the file is
/// opened without locks.
SqliteFile SqliteFile::readLogAlone(const std::string& path, int longest)
{
    SqliteFile alone = readLog(path, longest, "mode=ro&vfs=unix-none");
    checkSqlite(sqlite3_db_config(alone.file_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr),
                alone.file_.get());
    alone.run("PRAGMA locking_mode = EXCLUSIVE");
    static_cast<void>(alone.integer("PRAGMA schema_version"));
    return alone;
}

/// Opens a file in WAL mode that has a journal. SQLite makes no index beside it.
SqliteFile SqliteFile::readJournaled(const std::string& path, int longest, std::string_view options)
{
    requireReadableJournal(path);
    if (JournalFrames(journalOf(path)).hasDamagedHeader())
        return openLogWithoutJournal(path, longest);
    std::error_code none;
    // Without an index no connection writes: neither of this process nor of another.
    if (std::filesystem::exists(besideFile(path, "-shm"), none)) {
        SqliteFile file = readLog(path, longest, options);
        if (file.isReadable()) return file;
    }
    return readLogAlone(path, longest);
}

/// Takes the lock that SQLite takes for a reader. It belongs to its descriptor, so closing another
/// descriptor of this process does not release it.
SqliteFile::Lock SqliteFile::readerLock(const std::string& path)
{
    constexpr off_t kSharedFirst = 0x40000002, kSharedBytes = 510;
    Lock lock(std::fopen(path.c_str(), "rbe"));
    if (!lock) return lock;
    struct flock shared = {};
    shared.l_type = F_RDLCK;
    shared.l_whence = SEEK_SET;
    shared.l_start = kSharedFirst;
    shared.l_len = kSharedBytes;
    (void)::fcntl(::fileno(lock.get()), F_OFD_SETLK, &shared);  // not every file system has locks
    return lock;
}

SqliteFile SqliteFile::openLog(const std::string& path, int longest)
{
    const bool journaled = isJournaled(path);
    if (!journaled) checkSize(path, std::numeric_limits<std::uintmax_t>::max());
    if (!journaled || lacksJournal(path)) return openLogWithoutJournal(path, longest);
    std::error_code none;
    Lock lock;  // with an index, SQLite takes it
    if (!std::filesystem::exists(besideFile(path, "-shm"), none)) lock = readerLock(path);
    SqliteFile file = readJournaled(path, longest, "mode=ro");
    file.lock_ = std::move(lock);
    return file;
}

SqliteFile SqliteFile::openLogWithoutJournal(const std::string& path, int longest)
{
    requireFile(path);
    return readLog(path, longest, "mode=ro&immutable=1");
}

SqliteFile SqliteFile::openLogWithoutTrace(const std::string& path, int longest)
{
    const std::filesystem::path journal = journalOf(path);
    std::error_code none;
    if (!std::filesystem::exists(journal, none) || lacksJournal(path))
        return openLog(path, longest);
    return readJournaled(path, longest, "mode=ro&readonly_shm=1");
}

bool SqliteFile::readsJournal()
{
    SqliteStatement mode = prepare("PRAGMA journal_mode");
    return mode.step() && mode.text(0) == "wal";
}

void SqliteFile::requireNothingBeside(const std::string& path)
{
    for (const char* const end : {"-wal", "-shm", "-journal"}) {
        const std::string beside = besideFile(path, end);
        std::error_code none;
        if (std::filesystem::exists(std::filesystem::symlink_status(beside, none)))
            throw SqliteError(
                Message(TR_NOOP("core", "%1 is there already and would be taken for its journal: "
                                        "name another file"),
                        printable(std::filesystem::path(beside).filename().string())));
    }
}

void SqliteFile::makeEmpty(const std::string& path)
{
    std::error_code none;
    if (!std::filesystem::exists(path, none)) requireNothingBeside(path);  // else open() fails
    const int made =
        ::open(path.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (made < 0)
        throw SqliteError(
            errno == EEXIST
                ? Message(TR_NOOP("core", "is there already: name another file"))
                : Message(TR_NOOP("core", "cannot be created: %1"), systemMessage(errno)));
    (void)::fchmod(made, S_IRUSR | S_IWUSR);  // the umask may have taken away more
    ::close(made);
}

SqliteFile SqliteFile::createLog(const std::string& path)
{
    makeEmpty(path);
    try {
        SqliteFile file(path, SQLITE_OPEN_READWRITE);
        file.run("PRAGMA page_size = 8192");
        file.journal();
        return file;
    } catch (...) {
        ::unlink(path.c_str());
        throw;
    }
}

SqliteFile SqliteFile::reopenLog(const std::string& path)
{
    SqliteFile file(path, SQLITE_OPEN_READWRITE);
    file.harden();
    file.journal();
    return file;
}

void SqliteFile::checkpoint()
{
    run("PRAGMA wal_checkpoint(PASSIVE)");
}

void SqliteFile::journal()
{
    SqliteStatement mode = prepare("PRAGMA journal_mode = WAL");
    if (!mode.step() || mode.text(0) != "wal")
        throw SqliteError(TR_NOOP("core", "its file system keeps no write-ahead journal"));
    run("PRAGMA synchronous = FULL");
    // A file in WAL mode without a journal is then one whose journal was removed.
    checkSqlite(sqlite3_db_config(file_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr),
                file_.get());
    run("PRAGMA journal_size_limit = 67108864");
    // a failing checkpoint would be reported as a failing commit; see checkpoint()
    run("PRAGMA wal_autocheckpoint = 0");
}

bool SqliteFile::leaveJournal()
{
    const SqliteStatement mode = prepare("PRAGMA journal_mode = DELETE");
    const int code = sqlite3_step(mode.statement_.get());
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) return false;
    if (code != SQLITE_ROW) throw sqliteFailure(file_.get());
    return mode.text(0) == "delete";
}

SqliteFile SqliteFile::fill(const std::string& path)
{
    SqliteFile file(path, SQLITE_OPEN_READWRITE);
    file.run("PRAGMA journal_mode = OFF");
    file.run("PRAGMA synchronous = OFF");
    return file;
}

SqliteStatement SqliteFile::prepare(std::string_view sql)
{
    sqlite3_stmt* statement = nullptr;
    checkSqlite(sqlite3_prepare_v2(file_.get(), sql.data(), static_cast<int>(sql.size()),
                                   &statement, nullptr),
                file_.get());
    return SqliteStatement(statement, bytesLeft_.get());
}

std::int64_t SqliteFile::integer(std::string_view sql)
{
    SqliteStatement statement = prepare(sql);
    if (!statement.step()) throw SqliteError(TR_NOOP("core", "a number is missing"));
    return statement.integer(0);
}

void SqliteFile::close()
{
    checkSqlite(sqlite3_close(file_.get()), file_.get());
    static_cast<void>(file_.release());
}

}  // namespace terratact
