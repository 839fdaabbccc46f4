#pragma once

#include <limits>

namespace terratact {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace terratact
