#pragma once

#include <array>

namespace terratact {

/// Rotation matrix, row by row: v_to = R v_from.
using Rotation = std::array<std::array<double, 3>, 3>;

/// Returns the rotation of a quaternion, which need not have the length 1. Throws std::invalid_argument
/// unless its length is finite and above 0.
Rotation rotationOf(double x, double y, double z, double w);

/// Returns the rotation about z by yaw, about the new y by pitch, then about the new x by roll.
/// Angles [rad] are defined as by ROS (REP 103).
Rotation rotationOfAngles(double roll, double pitch, double yaw);

Rotation product(const Rotation& a, const Rotation& b);
Rotation transposed(const Rotation& r);

/// Angles [rad] of a base (x forward, y left, z up) in axes with z up. Positive are: pitch with the nose
/// up, roll with the left side up, heading to the left.
struct BaseAngles {
    double pitch = 0.0, roll = 0.0, heading = 0.0;
};
BaseAngles baseAngles(const Rotation& base);

}  // namespace terratact
