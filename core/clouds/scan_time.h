#pragma once

#include <optional>
#include <string>

namespace terratact {

/// Returns the time that the name of a scan's file spells [s]: the last number in it, in ns from 1e15 on.
std::optional<double> scanTimeIn(const std::string& path);

}  // namespace terratact
