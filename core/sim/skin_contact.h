#pragma once

#include <optional>
#include <vector>

#include "core/robot/robot_model.h"

namespace terratact {

/// Penetration of a point into a convex part of the robot.
struct Penetration {
    Vec2 normal;         ///< unit vector out of the part at the nearest point of its boundary
    double depth = 0.0;  ///< distance to that point, > 0 [m]
};

/// Part of the robot with a skin [m], prepared for many queries. If one circle contains the other,
/// it is a disc.
class SkinHull {
public:
    SkinHull(const TaperedHull& hull, double skin);
    double xBegin() const { return xBegin_; }
    double xEnd() const { return xEnd_; }
    /// Returns how deep p lies inside; empty if it is outside.
    std::optional<Penetration> penetration(Vec2 p) const;

private:
    TaperedHull hull_;  // radii grown by the skin
    Vec2 axis_;         // unit, a to b
    double length_;     // |b − a|
    bool disc_;
    double sine_,
        // Sine and cosine of the taper: a straight side has the normal (sine, ±cosine) in the axis
        // frame.
        cosine_;
    double xBegin_, xEnd_, zBegin_;
};

class SkinPolygon {
public:
    /// polygon: convex, at least three corners, in either direction. Corners that are all equal
    /// touch nothing.
    SkinPolygon(const std::vector<Vec2>& polygon, double skin);
    double xBegin() const { return xBegin_; }
    double xEnd() const { return xEnd_; }
    /// Returns how deep p lies inside, where corners of the skin are square; empty if it is
    /// outside.
    std::optional<Penetration> penetration(Vec2 p) const;

private:
    struct Edge {
        Vec2 corner, normal;
    };
    std::vector<Edge> edges_;
    double skin_;
    double xBegin_, xEnd_, zBegin_;
};

}  // namespace terratact
