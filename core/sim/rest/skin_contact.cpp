#include "core/sim/rest/skin_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terratact {

namespace {

double dotProduct(Vec2 a, Vec2 b)
{
    return a.x * b.x + a.z * b.z;
}

Vec2 minus(Vec2 a, Vec2 b)
{
    return {a.x - b.x, a.z - b.z};
}

std::optional<Penetration> inCircle(Vec2 centre, double radius, Vec2 q)
{
    const Vec2 r = minus(q, centre);
    const double length2 = dotProduct(r, r);
    if (length2 >= radius * radius) return std::nullopt;
    const double length = std::sqrt(length2);
    const Vec2 normal = length > 0.0 ? Vec2{r.x / length, r.z / length} : Vec2{0.0, -1.0};
    return Penetration{normal, radius - length, length};
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
std::optional<Penetration> SkinHull::penetration(Vec2 p) const
{
    if (p.z < zBegin_) return std::nullopt;
    if (disc_)
        return hull_.ra >= hull_.rb ? inCircle(hull_.a, hull_.ra, p)
                                    : inCircle(hull_.b, hull_.rb, p);
    const Vec2 r = minus(p, hull_.a);
    const double along = dotProduct(r, axis_);
    const double across = r.z * axis_.x - r.x * axis_.z;
    const double onSide = cosine_ * along - sine_ * std::abs(across);
    if (onSide < 0.0) return inCircle(hull_.a, hull_.ra, p);
    if (onSide > cosine_ * length_) return inCircle(hull_.b, hull_.rb, p);
    const double depth = hull_.ra - sine_ * along - cosine_ * std::abs(across);
    if (depth <= 0.0) return std::nullopt;
    const double side = across < 0.0 ? -1.0 : 1.0;
    return Penetration{
        {sine_ * axis_.x - side * cosine_ * axis_.z, sine_ * axis_.z + side * cosine_ * axis_.x},
        depth,
        0.0};
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
        if (dotProduct(normal, minus(centre, polygon[i])) > 0.0) normal = {-normal.x, -normal.z};
        edges_.push_back({polygon[i], normal});
    }
}

std::optional<Penetration> SkinPolygon::penetration(Vec2 p) const
{
    if (p.z < zBegin_ || edges_.empty()) return std::nullopt;
    Penetration nearest{{}, std::numeric_limits<double>::infinity(), 0.0};
    for (const Edge& edge : edges_) {
        const double depth = skin_ - dotProduct(edge.normal, minus(p, edge.corner));
        if (depth < nearest.depth) nearest = {edge.normal, depth, 0.0};
    }
    if (nearest.depth <= 0.0) return std::nullopt;
    return nearest;
}

}  // namespace terratact
