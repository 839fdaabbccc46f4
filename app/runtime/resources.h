#pragma once

#include <string>

namespace terratact {

/// Path of a file the program ships, such as "robots/absolem.toml": in share/terratact beside the folder of the
/// running program, wherever that was installed, moved or unpacked.  A build tree has a link there to the source
/// tree's resources, so that no path of the building machine is compiled in.
/// Whether the file is there is for its reader to say.  Throws std::filesystem::filesystem_error without /proc.
std::string resourcePath(const std::string& name);

}  // namespace terratact
