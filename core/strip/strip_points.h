#pragma once

#include <cstddef>
#include <vector>

#include "core/strip/strip.h"

namespace terratact {

/// A bin of a strip as a point. Frame of its section: x forward and y left of the IMU of the
/// section's first scene, z up along gravity [m].
struct StripPoint {
    double x = 0.0, y = 0.0, z = 0.0;
    std::size_t section = 0;  ///< index in Strip::sections()
    std::size_t side = 0;     ///< 0: left, 1: right
    double along = 0.0;       ///< [m] x of the bin's centre along the way
    double driftSd = 0.0;     ///< [m] sd of its height by the way since the section's begin
    const StripBin* bin = nullptr;
    const StripSource* source = nullptr;
};

/// Returns all bins of a strip as points, by section, column and side. A bin lies on the line of its side's track or
/// flipper (core/terrain/ground_lines.h). That line runs along the heading that the robot had in the scene. The
/// pointers are valid until the strip changes.
std::vector<StripPoint> pointsOf(const Strip& strip, const RobotModel& robot);

}  // namespace terratact
