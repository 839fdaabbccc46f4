#pragma once

#include <array>
#include <vector>

#include "core/robot/kinematics.h"
#include "core/sim/rest/ground_contact.h"

namespace terratact {

/// Lower edge of a flipper in a pose.
struct FlipperEdge {
    const FlipperGeometry& flipper;
    double angle = 0.0;  ///< [rad]
    Pose pose;           ///< of the plane in which the flipper turns
};

/// Returns the forces on six elements of a flipper's lower edge [N], at `elementShare` of its
/// length. Of every contact of that part, a `share` of the force is on this flipper. The two nearest
/// elements share its component normal to the edge like the supports of a beam. Forces on the pivot
/// circle, which has no sensor, are ignored. Not saturated.
std::array<double, kForceElements>
edgeForces(const FlipperEdge& edge, const std::array<double, kForceElements>& elementShare,
           const std::vector<GroundContact>& contacts, GroundContact::Part part, double share);

}  // namespace terratact
