#pragma once

#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"
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

/// Returns the ceilings of one side at these readings, with a locked differential. For bins −0.3 …
/// 0.2 m they are those of the plane of the side's track. From 0.3 m on they are those of the plane
/// of its flippers, like sideHeights() (core/terrain/ground_lines.h). They hold for a robot that
/// fills its width: a flipper is a ceiling above the track's line too. Throws std::invalid_argument
/// unless finite.
Heights sideCeiling(const RobotModel& robot, const TwoTrackReadings& s, Side side);

/// Returns the side view for a picture: body, tracks and flippers as polygons, DEM frame.
Outline robotOutline(const RobotModel& robot, double pitch, double front, double rear);

}  // namespace terratact
