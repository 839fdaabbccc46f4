#pragma once

#include <algorithm>
#include <cmath>

namespace terratact {

/// δ of the log clearance [m]: a smaller clearance counts as touching.
inline constexpr double kClearanceOffset = 0.003;

/// Returns the log clearance, the state of the sampler over clearances (method `clearance`):
///   under the robot (finite ceiling)   y = log(max(ceiling − height, 0) + δ)
///   elsewhere (ceiling +infinity)      y = height
/// height, ceiling: [m], DEM frame. Source: warped Gaussian processes, Snelson, Rasmussen,
/// Ghahramani (NIPS 2004), with the robot's kinematics as the reference of the warp.
inline double toLogClearance(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::log(std::max(ceiling - height, 0.0) + kClearanceOffset);
}

/// Returns the height [m] of a log clearance: ceiling − max(exp(y) − δ, 0), or y; never above the
/// ceiling.
inline double fromLogClearance(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::max(std::exp(y) - kClearanceOffset, 0.0);
}

/// Returns the sd of a log clearance whose height has the sd s [m]: half of its change from height − s to height + s.
inline double logClearanceSd(double height, double s, double ceiling)
{
    return 0.5
         * std::abs(toLogClearance(height + s, ceiling) - toLogClearance(height - s, ceiling));
}

/// a of the surface coordinate [m]: it is linear below a and logarithmic above.
inline constexpr double kSurfaceScale = 0.01;

/// Largest depth [m] to which the robot sinks into ground that carries it.
inline constexpr double kDeepestSinking = 0.03;

/// Largest clearance [m] that a surface coordinate stands for. Readings that contradict each other
/// lead to coordinates whose sinh is kilometres.
inline constexpr double kDeepestSurface = 5.0;

/// Returns the surface coordinate, in which the closed forms (methods `joint`, `local`) predict a
/// bin's height:
///   under the robot   y = asinh((ceiling − height) / a)
///   elsewhere         y = height
/// It behaves like the log clearance far below the body, but is also defined above the body's lower
/// edge. A robot that has sunk into soft ground has the surface beside its tracks there, at most
/// kDeepestSinking above.
inline double toSurface(double height, double ceiling)
{
    if (std::isinf(ceiling)) return height;
    return std::asinh(std::max(ceiling - height, -kDeepestSinking) / kSurfaceScale);
}

/// Returns the sd of a surface coordinate whose height has the sd s [m]: half of its change from height − s to
/// height + s.
inline double surfaceSd(double height, double s, double ceiling)
{
    return 0.5 * std::abs(toSurface(height + s, ceiling) - toSurface(height - s, ceiling));
}

/// Returns the height [m] of a surface coordinate; at most kDeepestSinking above the ceiling, and at
/// most kDeepestSurface below.
inline double toHeight(double y, double ceiling)
{
    if (std::isinf(ceiling)) return y;
    return ceiling - std::clamp(kSurfaceScale * std::sinh(y), -kDeepestSinking, kDeepestSurface);
}

}  // namespace terratact
