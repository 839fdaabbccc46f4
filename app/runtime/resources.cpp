#include "app/runtime/resources.h"

#include <filesystem>

namespace terratact {

std::string resourcePath(const std::string& name)
{
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    return (program.parent_path().parent_path() / "share/terratact" / name).string();
}

std::string shippedModelPath()
{
    return resourcePath("models/default.ttm");
}

std::string shippedTrailPath()
{
    return resourcePath("models/default.ttn");
}

std::string trailPathBeside(const std::string& modelPath)
{
    return std::filesystem::path(modelPath).replace_extension(".ttn").string();
}

std::vector<std::string> shippedModelPaths()
{
    return {shippedModelPath(), resourcePath("models/one_plane.ttm")};
}

}  // namespace terratact
