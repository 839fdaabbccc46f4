#pragma once

#include <optional>
#include <vector>

#include "core/robot/robot_model.h"

namespace terratact {

/// A point inside a convex part of the robot.
struct Penetration {
    Vec2 normal;         ///< unit, out of the part at the nearest point of its boundary
    double depth = 0.0;  ///< [m] distance to that point, > 0
};

/// A part of the robot grown by a skin [m], prepared for many queries.  Where one circle holds the other it is
/// a disc.
class SkinHull {
public:
    SkinHull(const TaperedHull& hull, double skin);
    double xBegin() const { return xBegin_; }
    double xEnd() const { return xEnd_; }
    /// How deep p lies inside; empty where it is outside.
    std::optional<Penetration> penetration(Vec2 p) const;

private:
    TaperedHull hull_;  // radii grown by the skin
    Vec2 axis_;         // unit, a to b
    double length_;     // |b − a|
    bool disc_;
    double sine_,
        cosine_;  // of the taper: normal of a straight side = (sine, ±cosine) in the axis frame
    double xBegin_, xEnd_, zBegin_;
};

class SkinPolygon {
public:
    /// polygon: convex, at least three corners, either way round.  Corners that are all the same touch nothing.
    SkinPolygon(const std::vector<Vec2>& polygon, double skin);
    double xBegin() const { return xBegin_; }
    double xEnd() const { return xEnd_; }
    /// How deep p lies inside (corners of the skin are square); empty where it is outside.
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
