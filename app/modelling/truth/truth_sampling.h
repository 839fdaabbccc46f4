#pragma once

#include <cstddef>

#include "app/modelling/truth/laser_truth.h"

namespace terratact {

/// Finds the heights of both sides and of the plane in the cells of a place, with the scene's correction. Sets
/// SceneTruth::gap to None, or to NoCloud if no bin is known.
void sampleTruth(SceneTruth& scene, const RobotModel& robot, const SceneGrid& grid,
                 std::size_t place, const TruthRule& rule);

/// Puts the heights of a row, and their sds, into the scene of the file.
void putTruth(LaserTruth& truth, std::size_t row);

}  // namespace terratact
