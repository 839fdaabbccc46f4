#pragma once

#include <algorithm>
#include <cmath>

namespace terratact {

/// δ of the surface coordinate [m]: how far below the body "touching" ends.
inline constexpr double kClearanceOffset = 0.003;

/// The coordinate in which a bin's height is modelled:
///   under the robot (finite ceiling)   y = log(max(ceiling − height, 0) + δ)
///   elsewhere (ceiling +infinity)      y = height
/// height, ceiling: [m], DEM frame.
/// Source: warped Gaussian processes, Snelson, Rasmussen, Ghahramani (NIPS 2004), the robot's kinematics
/// giving the warp's reference.
inline double toSurface(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::log(std::max(ceiling - height, 0.0) + kClearanceOffset);
}

/// The height [m] of a coordinate: ceiling − max(exp(y) − δ, 0), or y; never above the ceiling.
inline double toHeight(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::max(std::exp(y) - kClearanceOffset, 0.0);
}

}  // namespace terratact
