#include "core/sim/rest/edge_forces.h"

#include <algorithm>

namespace terratact {
namespace {

/// Adds a force at `position` on the edge, 0 … 1, to the nearest elements.
void addForce(std::array<double, kForceElements>& force,
              const std::array<double, kForceElements>& elementShare, double position,
              double normal)
{
    std::size_t e = 0;
    while (e < kForceElements && elementShare[e] < position) ++e;
    if (e == 0) {
        force.front() += normal;
    } else if (e == kForceElements) {
        force.back() += normal;
    } else {
        const double t = (position - elementShare[e - 1]) / (elementShare[e] - elementShare[e - 1]);
        force[e - 1] += (1.0 - t) * normal;
        force[e] += t * normal;
    }
}

}  // namespace

std::array<double, kForceElements>
edgeForces(const FlipperEdge& edge, const std::array<double, kForceElements>& elementShare,
           const std::vector<GroundContact>& contacts, GroundContact::Part part, double share)
{
    std::array<double, kForceElements> force{};
    const Vec2 start = edgePoint(edge.flipper, edge.angle, edge.pose, 0.0);
    const double turn = turnSign(edge.flipper);
    const double elevation = edge.pose.pitch + turn * edge.angle;
    const Vec2 axis = rotated({turn, 0.0}, elevation);
    const Vec2 up = rotated({0.0, 1.0}, elevation);
    const double length = edge.flipper.edgeLength();
    for (const GroundContact& c : contacts) {
        if (c.part != part) continue;
        const double position = dot({c.point.x - start.x, c.point.z - start.z}, axis) / length;
        const double normal = share * std::max(0.0, dot(c.force, up));
        if (position >= 0.0) addForce(force, elementShare, position, normal);
    }
    return force;
}

}  // namespace terratact
