#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace terratact {

/// Returns the path of a file of real ground in the folder TERRATACT_TERRAIN. Empty if that
/// environment variable is not set or empty. Tests then skip.
inline std::optional<std::string> realGround(const std::string& file)
{
    const char* const folder = std::getenv("TERRATACT_TERRAIN");
    if (!folder || *folder == '\0') return std::nullopt;
    return std::string(folder) + "/" + file;
}

}  // namespace terratact
