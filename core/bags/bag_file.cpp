#include "core/bags/bag_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/system_message.h"
#include "core/store/file_read.h"

namespace terratact {

Result<BagFile> BagFile::open(const std::string& path)
{
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed))
        return fileError(
            path,
            failed ? failed.message()
                   : "is no regular file, and it is read back and forth: save it as a file first");
    std::ifstream file(path, std::ios::binary);
    const auto size = std::filesystem::file_size(path, failed);
    if (!file)
        return fileError(path,
                         Message::joined(TR_NOOP("core", "cannot be read"), systemMessage(errno)));
    if (failed) return fileError(path, failed.message());
    return BagFile(std::move(file), size);
}

void BagFile::goTo(std::uint64_t offset)
{
    at_ = std::min(offset, size_);
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at_));
}

bool BagFile::read(std::uint64_t count, std::uint64_t most, std::string& into)
{
    if (count > most || count > left()) return false;
    into.resize(static_cast<std::size_t>(count));
    file_.read(into.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::uint64_t>(file_.gcount()) != count) return false;
    at_ += count;
    return true;
}

}  // namespace terratact
