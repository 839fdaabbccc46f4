#pragma once

#include <string>

namespace terratact {

/// Returns the path of a shipped file, for example "robots/absolem.toml". It lies in share/terratact beside the folder
/// of the running program, wherever that was installed, moved or unpacked. In a build tree that is a link to the
/// sources' resources. No path of the build machine is compiled in. The reader of the file reports a missing file.
/// Throws std::filesystem::filesystem_error without /proc.
std::string resourcePath(const std::string& name);

}  // namespace terratact
