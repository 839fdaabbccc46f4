#pragma once

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"
#include "core/terrain/outline.h"

namespace terratact {

/// Returns the ceiling of every bin [m], DEM frame: the mean over the bin's 0.1 m of the robot's
/// lower envelope. It is +infinity where the robot does not cover part of the bin. Terrain that is
/// nowhere above the robot therefore has height ≤ ceiling in every bin. The midpoint rule on 1 mm
/// steps integrates it (error below 0.1 mm).
///
/// pitch, front, rear: [rad], signs as in Proprioception. Throws std::invalid_argument unless
/// finite.
Heights bodyCeiling(const RobotModel& robot, double pitch, double front, double rear);

/// Returns the side view for a picture: body, tracks and flippers as polygons, DEM frame.
Outline robotOutline(const RobotModel& robot, double pitch, double front, double rear);

}  // namespace terratact
