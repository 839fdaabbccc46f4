#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Forces [N] of the elements of each side, element 1 (pivot) … 6 (tip). Empty: the element is not
/// known by itself, the robot does not have it, or it is broken.
struct SideForces {
    std::array<std::optional<double>, kForceElements> left{}, right{};

    /// Returns true if a side of element `e` (0 … 5) is known.
    bool knows(std::size_t e) const { return left[e] || right[e]; }
    bool operator==(const SideForces&) const = default;
};

/// A line of telemetry with the force elements of both sides. Measurement::force is their mean, or
/// the side that is known.
struct SensedLine {
    Measurement measurement{};
    SideForces sides{};
    bool operator==(const SensedLine&) const = default;
};

}  // namespace terratact
