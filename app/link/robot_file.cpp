#include "app/link/robot_file.h"

#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxRobotBytes = 1U << 20U;  // bound of a session's robot text

}  // namespace

Result<RobotFile> readRobotFile(const std::string& path)
{
    auto text = readFile(path, kMaxRobotBytes);
    if (!text) return text.error();
    auto model = robotModelFrom(path, *text);
    if (!model) return model.error();
    std::string hash = sha256Hex(*text);
    return RobotFile{path, std::move(*text), std::move(hash), std::move(*model)};
}

}  // namespace terratact
