#pragma once

#include <algorithm>

#include "core/robot/robot_model.h"

namespace terratact {

/// Contact force between ground and robot.
struct GroundContact {
    enum class Part { Track, Front, Rear, Body };
    Part part = Part::Track;
    Vec2 point;          ///< terrain's frame [m]
    Vec2 force;          ///< on the robot [N]
    double depth = 0.0;  ///< compression of the skin [m]
};

/// Constants of ground and solver. Every point of the terrain's line, sampled at `spacing`, has a
/// spring. Between two springs a part of radius r sinks spacing²/8r deeper (0.1 mm for the
/// flippers' tip). The skin absorbs that, so that the body stays above the ground.
struct GroundOptions {
    double spacing = 0.005;  ///< [m]
    double skin = 2e-4;      ///< [m] thickness of the compressible skin around the robot
    double stiffness = 5e6;  ///< [N/m] per point
    /// Depth of soft ground on firm ground [m]; less than the least radius of the robot's parts.
    double softLayer = 0.0;
    double softStiffness = 0.0;  ///< stiffness of the soft layer, per point [N/m]
    /// A step of the search with a smaller gain ends it [J]. The pose is then within about 1e-6 rad of
    /// the minimum.
    double settled = 1e-11;
};

/// Spring of one point of the ground that is `depth` [m] inside of a part's skin:
///   energy = ½ (k_soft depth² + k max(0, depth − softLayer)²)
struct SkinSpring {
    double energy = 0.0;    ///< [J]
    double force = 0.0;     ///< [N] derivative of the energy
    double gradient = 0.0;  ///< [N/m] derivative of the force
};

/// stiffness: k [N/m], instead of ground.stiffness.
inline SkinSpring skinSpring(double depth, double stiffness, const GroundOptions& ground)
{
    const double firmDepth = std::max(0.0, depth - ground.softLayer);
    const double firm = stiffness * firmDepth;
    const double soft = ground.softStiffness * depth;
    return {.energy = 0.5 * firm * firmDepth + 0.5 * soft * depth,
            .force = firm + soft,
            .gradient = (firmDepth > 0.0 ? stiffness : 0.0) + ground.softStiffness};
}

}  // namespace terratact
