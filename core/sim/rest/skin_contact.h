#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/robot/robot_model.h"

namespace terratact {

/// Penetration of a point into a convex part of the robot.
struct Penetration {
    Vec2 normal;         ///< unit vector out of the part at the nearest point of its boundary
    double depth = 0.0;  ///< distance to that point, > 0 [m]
    /// Distance from p to the centre of the boundary's circle [m]; 0 on a straight side.
    double toCentre = 0.0;
};

/// Part of the robot with a skin [m], prepared for many queries. If one circle contains the other,
/// it is a disc.
class SkinHull {
public:
    SkinHull(const TaperedHull& hull, double skin);
    double xBegin() const { return xBegin_; }
    double xEnd() const { return xEnd_; }
    /// Finds how deep p lies inside. Returns false if it is outside; `found` is then undefined. Not an
    /// optional: its copies stalled the processor and took half the time of a simulated drive.
    bool penetration(Vec2 p, Penetration& found) const;

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
    /// The same, where corners of the skin are square.
    bool penetration(Vec2 p, Penetration& found) const;

private:
    struct Edge {
        Vec2 corner, normal;
    };
    std::vector<Edge> edges_;
    double skin_;
    double xBegin_, xEnd_, zBegin_;
};

/// Calls hit(point, penetration) for every point of a line along x that lies inside of the part.
/// Returns how many points it compared with the part.
template <class Part, class Hit>
std::size_t forEachHit(const std::vector<Vec2>& line, const Part& part, Hit hit)
{
    const auto before = [](Vec2 p, double x) { return p.x < x; };
    const auto first = std::lower_bound(line.begin(), line.end(), part.xBegin(), before);
    auto p = first;
    Penetration found;
    for (; p != line.end() && p->x <= part.xEnd(); ++p)
        if (part.penetration(*p, found)) hit(*p, found);
    return static_cast<std::size_t>(p - first);
}

}  // namespace terratact
