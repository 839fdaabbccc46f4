#pragma once

#include <string>

namespace terratact {

/// Path of a file the program ships, such as "robots/absolem.toml": ../share/terratact beside an installed
/// program, else the source tree's resources.
std::string resourcePath(const std::string& name);

}  // namespace terratact
