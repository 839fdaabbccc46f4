#include "app/recording/unfinished_session.h"

#include <filesystem>
#include <system_error>

namespace terratact {

void removeUnfinishedSession(const std::string& path)
{
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix, ignored);
}

}  // namespace terratact
