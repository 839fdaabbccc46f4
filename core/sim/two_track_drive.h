#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/learn/data/two_track_scene.h"
#include "core/sim/drive.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Drives a robot with two tracks over the stops in order and measures a scene at each. driveOver() of one plane is in
/// core/sim/drive.h. The search for a rest pose begins at the attitude of the stop before. On ground with several
/// stable rolls the robot keeps its roll. Only the conditions noise, ground and stood are used; throws
/// std::invalid_argument if another one is set.
std::vector<TwoTrackScene> driveOver(const RobotModel& robot, const GroundLines& terrain,
                                     const std::vector<double>& stops, const std::string& run,
                                     const DriveStyle& style, const DriveConditions& conditions,
                                     std::mt19937_64& rng, int& skipped);

}  // namespace terratact
