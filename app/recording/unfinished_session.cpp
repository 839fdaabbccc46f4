#include "app/recording/unfinished_session.h"

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/store/unfinished_files.h"

namespace terratact {
namespace {

constexpr std::array kFilesOfSession{"", "-journal", "-wal", "-shm"};

}  // namespace

SessionInProgress::SessionInProgress(std::string path) : path_(std::move(path))
{
    std::error_code none;
    if (std::filesystem::exists(path_, none)) return;  // of somebody else, and not replaced
    for (const char* const suffix : kFilesOfSession) noteUnfinished(path_ + suffix);
}

SessionInProgress::~SessionInProgress()
{
    for (const char* const suffix : kFilesOfSession) forgetUnfinished(path_ + suffix);
}

void removeUnfinishedSession(const std::string& path)
{
    std::error_code ignored;
    for (const char* const suffix : kFilesOfSession)
        std::filesystem::remove(path + suffix, ignored);
}

}  // namespace terratact
