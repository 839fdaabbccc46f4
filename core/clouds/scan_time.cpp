#include "core/clouds/scan_time.h"

#include <filesystem>
#include <string_view>

#include "core/base/text.h"

namespace terratact {

std::optional<double> scanTimeIn(const std::string& path)
{
    const std::string name = std::filesystem::path(path).stem().string();
    const std::size_t end = name.find_last_of("0123456789");
    if (end == std::string::npos) return std::nullopt;
    const std::size_t before = name.find_last_not_of("0123456789.", end);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const auto time = numberFrom(std::string_view(name).substr(begin, end + 1 - begin));
    if (!time) return std::nullopt;
    return *time >= 1e15 ? *time * 1e-9 : *time;
}

}  // namespace terratact
