#include "app/cli/session/open_session.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <fstream>

#include "core/log/rows/session_schema.h"
#include "core/store/content_kind.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

/// Returns true if the header names a version that this program reads. A file of another version is
/// not damaged. Source: sqlite.org/fileformat2.html §1.3.
bool isOfReadableVersion(const std::string& path)
{
    constexpr std::size_t kUserVersion = 60;  // four bytes, most significant first
    std::array<char, kContentHead> head{};
    std::ifstream(path, std::ios::binary).read(head.data(), head.size());
    return head[kUserVersion] == 0 && head[kUserVersion + 1] == 0 && head[kUserVersion + 2] == 0
        && head[kUserVersion + 3] > 0 && head[kUserVersion + 3] <= kSessionVersion;
}

/// Returns false if the user has to put the journal right first.
bool canReadJournal(const std::string& path)
{
    try {
        SqliteFile::requireReadableJournal(path);
        return true;
    } catch (const SqliteError&) {
        return false;
    }
}

/// Returns true if the process or the system has too many open files: the session may be whole.
bool lacksOpenFiles(const Error& error)
{
    return error.code == EMFILE || error.code == ENFILE;
}

}  // namespace

Result<SessionReader> openSession(const std::string& path)
{
    auto session = SessionReader::open(path);
    if (session || lacksOpenFiles(session.error())
        || contentKindOfFile(path) != ContentKind::Session || !isOfReadableVersion(path)
        || !canReadJournal(path))
        return session;
    return Error{fmt::format("{}; `terratact session recover` saves what is whole in it",
                             session.error().text)};
}

}  // namespace terratact
