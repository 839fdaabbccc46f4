#include "app/resources.h"

#include <filesystem>

namespace terratact {

std::string resourcePath(const std::string& name)
{
    std::error_code failed;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    const std::filesystem::path installed =
        program.parent_path().parent_path() / "share/terratact" / name;
    if (!failed && std::filesystem::exists(installed, failed)) return installed.string();
    return std::string(TERRATACT_RESOURCES) + "/" + name;
}

}  // namespace terratact
