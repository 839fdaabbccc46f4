#pragma once

#include <optional>
#include <string>

namespace terratact {

/// Returns the time in the name of a scan's file [s]. It is the last number there; numbers from 1e15 on are in ns.
std::optional<double> scanTimeIn(const std::string& path);

}  // namespace terratact
