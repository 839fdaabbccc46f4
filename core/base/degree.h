#pragma once

#include <numbers>

namespace terratact {

/// One degree [rad]: 3.0 * kDegree is three degrees; an angle divided by kDegree is in degrees.
inline constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace terratact
