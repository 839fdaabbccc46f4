#include "core/clouds/cloud_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::size_t kCloudBuffer = std::size_t{64} * 1024;

}  // namespace

Result<CloudFile> CloudFile::open(const std::string& path)
{
    auto file = BagFile::open(path);
    if (!file) return file.error();
    return CloudFile(path, *std::move(file));
}

bool CloudFile::fill()
{
    used_ = 0;
    const std::uint64_t count = std::min<std::uint64_t>(kCloudBuffer, file_.left());
    if (count == 0 || !file_.read(count, kCloudBuffer, buffer_)) {
        buffer_.clear();
        return false;
    }
    return true;
}

Result<bool> CloudFile::line(std::string& line)
{
    line.clear();
    bool found = false;
    while (used_ < buffer_.size() || fill()) {
        if (!found) ++lines_;
        found = true;
        const std::string_view rest = std::string_view(buffer_).substr(used_);
        const std::size_t end = rest.find('\n');
        const std::string_view part = rest.substr(0, end);
        if (line.size() + part.size() > kMaxLine)
            return lineError(
                fmt::format("is longer than {} bytes, and no line of a text is: correct "
                            "the format that the header names",
                            kMaxLine));
        line += part;
        used_ += part.size();
        if (end == std::string_view::npos) continue;
        ++used_;
        break;
    }
    if (line.ends_with('\r')) line.pop_back();
    return found;
}

std::size_t CloudFile::read(std::size_t count, std::string& into)
{
    into.clear();
    while (into.size() < count && (used_ < buffer_.size() || fill())) {
        const std::size_t part = std::min(count - into.size(), buffer_.size() - used_);
        into.append(buffer_, used_, part);
        used_ += part;
    }
    return into.size();
}

void CloudFile::goTo(std::uint64_t offset)
{
    file_.goTo(offset);
    buffer_.clear();
    used_ = 0;
}

Result<std::string> CloudFile::behind(std::string_view points)
{
    const std::uint64_t begin = at(), bytes = left();
    if (bytes == 0) return std::string();
    std::string all;
    if (bytes <= kMaxPadding && read(kMaxPadding, all) == bytes
        && all.find_first_not_of('\0') == std::string::npos)
        return fmt::format("has {} zeros behind the {} that its header declares; they are not read",
                           bytes, points);
    return error(fmt::format("has {} bytes behind the {} that its header declares, from byte {} "
                             "on: correct the header, or cut the file there",
                             bytes, points, begin));
}

Error CloudFile::error(std::string_view cause) const
{
    return fileError(path_, cause);
}

Error CloudFile::lineError(std::string_view cause) const
{
    return lineError(cause, lines_);
}

Error CloudFile::lineError(std::string_view cause, std::uint64_t line) const
{
    return fileError(path_, fmt::format("line {}: {}", line, cause));
}

}  // namespace terratact
