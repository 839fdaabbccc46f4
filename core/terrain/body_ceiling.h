#pragma once

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"
#include "core/terrain/outline.h"

namespace terratact {

/// Ceiling of every bin [m], DEM frame: the mean over the bin's 0.1 m of the robot's lower envelope,
/// +infinity where nothing is above part of the bin.  Terrain nowhere above the robot therefore has
/// height ≤ ceiling in every bin.  Integrated by the midpoint rule on 1 mm steps (error below 0.1 mm).
///
/// pitch, front, rear: [rad], signs as in Proprioception.  Throws std::invalid_argument unless finite.
Heights bodyCeiling(const RobotModel& robot, double pitch, double front, double rear);

/// The side view for a picture: body, tracks and flippers as polygons, DEM frame.
Outline robotOutline(const RobotModel& robot, double pitch, double front, double rear);

}  // namespace terratact
