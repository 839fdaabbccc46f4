#pragma once

#include <algorithm>
#include <cmath>

namespace terratact {

/// δ [m]: a clearance this small is told apart from none only halfway.
inline constexpr double kClearanceOffset = 0.003;

/// Where the ground of a bin is, on the scale that is modelled:
///   covered (finite ceiling)  y = log(max(ceiling − height, 0) + δ)
///   open (ceiling +infinity)  y = height [m]
inline double toSurface(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::log(std::max(ceiling - height, 0.0) + kClearanceOffset);
}

/// The other way round: covered ceiling − max(exp(y) − δ, 0), never above the ceiling; open y.  [m]
inline double toHeight(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::max(std::exp(y) - kClearanceOffset, 0.0);
}

}  // namespace terratact
