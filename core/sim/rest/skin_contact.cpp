#include "core/sim/rest/skin_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terratact {

namespace {

Vec2 minus(Vec2 a, Vec2 b)
{
    return {a.x - b.x, a.z - b.z};
}

bool inCircle(Vec2 centre, double radius, Vec2 q, Penetration& found)
{
    const Vec2 r = minus(q, centre);
    const double length2 = dot(r, r);
    if (length2 >= radius * radius) return false;
    found.toCentre = std::sqrt(length2);
    found.depth = radius - found.toCentre;
    found.normal.x = found.toCentre > 0.0 ? r.x / found.toCentre : 0.0;
    found.normal.z = found.toCentre > 0.0 ? r.z / found.toCentre : -1.0;
    return true;
}

}  // namespace

SkinHull::SkinHull(const TaperedHull& hull, double skin)
    : hull_{hull.a, hull.b, hull.ra + skin, hull.rb + skin}, axis_(minus(hull.b, hull.a)),
      length_(std::hypot(axis_.x, axis_.z)), disc_(length_ <= std::abs(hull.ra - hull.rb)),
      sine_(disc_ ? 0.0 : (hull.ra - hull.rb) / length_), cosine_(std::sqrt(1.0 - sine_ * sine_)),
      xBegin_(std::min(hull.a.x - hull_.ra, hull.b.x - hull_.rb)),
      xEnd_(std::max(hull.a.x + hull_.ra, hull.b.x + hull_.rb)),
      zBegin_(std::min(hull.a.z - hull_.ra, hull.b.z - hull_.rb))
{
    if (!disc_) axis_ = {axis_.x / length_, axis_.z / length_};
}

/// Uses the straight side if the point projects onto it, else the circle of the nearer end.
bool SkinHull::penetration(Vec2 p, Penetration& found) const
{
    if (p.z < zBegin_) return false;
    if (disc_)
        return hull_.ra >= hull_.rb ? inCircle(hull_.a, hull_.ra, p, found)
                                    : inCircle(hull_.b, hull_.rb, p, found);
    const Vec2 r = minus(p, hull_.a);
    const double along = dot(r, axis_);
    const double across = r.z * axis_.x - r.x * axis_.z;
    const double onSide = cosine_ * along - sine_ * std::abs(across);
    if (onSide < 0.0) return inCircle(hull_.a, hull_.ra, p, found);
    if (onSide > cosine_ * length_) return inCircle(hull_.b, hull_.rb, p, found);
    const double depth = hull_.ra - sine_ * along - cosine_ * std::abs(across);
    if (depth <= 0.0) return false;
    const double side = across < 0.0 ? -1.0 : 1.0;
    found.normal.x = sine_ * axis_.x - side * cosine_ * axis_.z;
    found.normal.z = sine_ * axis_.z + side * cosine_ * axis_.x;
    found.depth = depth;
    found.toCentre = 0.0;
    return true;
}

SkinPolygon::SkinPolygon(const std::vector<Vec2>& polygon, double skin)
    : skin_(skin), xBegin_(std::numeric_limits<double>::infinity()), xEnd_(-xBegin_),
      zBegin_(xBegin_)
{
    Vec2 centre{};
    for (const Vec2 p : polygon) {
        centre = {centre.x + p.x / static_cast<double>(polygon.size()),
                  centre.z + p.z / static_cast<double>(polygon.size())};
        xBegin_ = std::min(xBegin_, p.x - skin);
        xEnd_ = std::max(xEnd_, p.x + skin);
        zBegin_ = std::min(zBegin_, p.z - skin);
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 e = minus(polygon[(i + 1) % polygon.size()], polygon[i]);
        const double length = std::hypot(e.x, e.z);
        if (length == 0.0) continue;
        Vec2 normal{e.z / length, -e.x / length};
        if (dot(normal, minus(centre, polygon[i])) > 0.0) normal = {-normal.x, -normal.z};
        edges_.push_back({polygon[i], normal});
    }
}

bool SkinPolygon::penetration(Vec2 p, Penetration& found) const
{
    if (p.z < zBegin_ || edges_.empty()) return false;
    found.depth = std::numeric_limits<double>::infinity();
    found.toCentre = 0.0;
    for (const Edge& edge : edges_) {
        const double depth = skin_ - dot(edge.normal, minus(p, edge.corner));
        if (depth >= found.depth) continue;
        found.normal = edge.normal;
        found.depth = depth;
    }
    return found.depth > 0.0;
}

}  // namespace terratact
