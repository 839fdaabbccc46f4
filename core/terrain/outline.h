#pragma once

#include <array>
#include <string>
#include <vector>

namespace terratact {

/// Closed polygon of the robot sketch in the DEM frame: points (x, z) [m].
struct OutlinePart {
    enum class Kind { Body, Track, FrontFlipper, RearFlipper };
    Kind kind = Kind::Body;
    std::vector<std::array<double, 2>> points;
    bool operator==(const OutlinePart&) const = default;
};

/// Side view of the robot as drawn under an estimate, back to front.
using Outline = std::vector<OutlinePart>;

}  // namespace terratact
