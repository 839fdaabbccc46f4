// Limits for files that may be hostile: steps, lengths, features, structure.
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "core/store/sqlite.h"
#include "core/store/sqlite_error.h"

namespace terratact {
namespace {

/// Ends long statements of a hostile file. SQLite calls stopNow() every kStepsPerCall steps.
constexpr int kStepsPerCall = 100'000;
constexpr std::int64_t kCalls = 1'000;
constexpr std::int64_t kLogCalls = 100;  // of a log: beside a step for each byte
int stopNow(void* callsLeft)
{
    return --*static_cast<std::int64_t*>(callsLeft) < 0 ? 1 : 0;
}

}  // namespace

void SqliteFile::grantSteps()
{
    if (callsLeft_) *callsLeft_ = kCalls;
}

void SqliteFile::grantPasses(int times)
{
    if (!bytesLeft_) return;
    size_ = 0;
    for (const std::string& part : {path_, journalOf(path_)}) {
        std::error_code none;
        const std::uintmax_t size = std::filesystem::file_size(part, none);
        if (!none) size_ += static_cast<std::int64_t>(size);
    }
    *bytesLeft_ = times * size_;
    *callsLeft_ = kLogCalls + *bytesLeft_ / kStepsPerCall;
}

// Applies sqlite.org/security.html, "Untrusted SQLite Database Files".
void SqliteFile::harden()
{
    sqlite3* const file = file_.get();
    checkSqlite(sqlite3_db_config(file, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr), file);
    checkSqlite(sqlite3_db_config(file, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr), file);
    checkSqlite(sqlite3_db_config(file, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr), file);
    checkSqlite(sqlite3_db_config(file, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr), file);
    sqlite3_limit(file, SQLITE_LIMIT_LENGTH, 1'000'000);
    sqlite3_limit(file, SQLITE_LIMIT_SQL_LENGTH, 100'000);
    sqlite3_limit(file, SQLITE_LIMIT_COLUMN, 100);
    sqlite3_limit(file, SQLITE_LIMIT_EXPR_DEPTH, 10);
    sqlite3_limit(file, SQLITE_LIMIT_COMPOUND_SELECT, 3);
    sqlite3_limit(file, SQLITE_LIMIT_VDBE_OP, 25'000);
    sqlite3_limit(file, SQLITE_LIMIT_FUNCTION_ARG, 8);
    sqlite3_limit(file, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(file, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 50);
    sqlite3_limit(file, SQLITE_LIMIT_VARIABLE_NUMBER, 64);
    sqlite3_limit(file, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
    callsLeft_ = std::make_unique<std::int64_t>(kCalls);
    sqlite3_progress_handler(file, kStepsPerCall, stopNow, callsLeft_.get());
    run("PRAGMA cell_size_check = ON");
    run("PRAGMA mmap_size = 0");
}

std::string SqliteFile::structureFault()
{
    if (callsLeft_) *callsLeft_ = kCalls + size_ / kStepsPerCall;
    SqliteStatement statement = prepare("PRAGMA integrity_check(1)");
    if (!statement.step()) throw SqliteError(TR_NOOP("core", "its structure cannot be checked"));
    std::string finding = statement.text(0);
    if (finding == "ok") return {};
    // SQLite reports SQLITE_NOMEM as a fault of a page.
    if (finding.ends_with("error code=7")
        && finding.find("unable to get the page") != std::string::npos)
        throw SqliteError(TR_NOOP("core", "out of memory"));
    std::replace(finding.begin(), finding.end(), '\n', ' ');
    return finding;
}

void SqliteFile::checkStructure()
{
    if (const std::string fault = structureFault(); !fault.empty())
        throw SqliteError(Message(TR_NOOP("core", "its structure is damaged: %1"), fault));
}

}  // namespace terratact
