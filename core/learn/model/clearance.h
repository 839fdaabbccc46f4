#pragma once

#include <algorithm>
#include <cmath>

namespace terratact {

/// δ of the log clearance [m]: how far below the body "touching" ends.
inline constexpr double kClearanceOffset = 0.003;

/// Log clearance, the state of the sampler over clearances (method `clearance`):
///   under the robot (finite ceiling)   y = log(max(ceiling − height, 0) + δ)
///   elsewhere (ceiling +infinity)      y = height
/// height, ceiling: [m], DEM frame.
/// Source: warped Gaussian processes, Snelson, Rasmussen, Ghahramani (NIPS 2004), the robot's kinematics
/// giving the warp's reference.
inline double toLogClearance(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::log(std::max(ceiling - height, 0.0) + kClearanceOffset);
}

/// The height [m] of a log clearance: ceiling − max(exp(y) − δ, 0), or y; never above the ceiling.
inline double fromLogClearance(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::max(std::exp(y) - kClearanceOffset, 0.0);
}

/// a of the surface coordinate [m]: linear within it, logarithmic beyond.
inline constexpr double kSurfaceScale = 0.01;

/// [m] The robot sinks no deeper into ground that carries it.
inline constexpr double kDeepestSinking = 0.03;

/// Surface coordinate, in which the closed forms (methods `joint`, `local`) predict a bin's height:
///   under the robot   y = asinh((ceiling − height) / a)
///   elsewhere         y = height
/// Like the log clearance far below the body, but defined above its lower edge, too: where the robot has
/// sunk into soft ground, the surface beside its tracks lies there, at most kDeepestSinking above.
inline double toSurface(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::asinh(std::max(ceiling - height, -kDeepestSinking) / kSurfaceScale);
}

/// The height [m] of a surface coordinate; never more than kDeepestSinking above the ceiling.
inline double toHeight(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::max(kSurfaceScale * std::sinh(y), -kDeepestSinking);
}

}  // namespace terratact
