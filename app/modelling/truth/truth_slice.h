#pragma once

#include <cstddef>
#include <vector>

#include "app/modelling/truth/laser_truth.h"

namespace terratact {

/// A point of the cloud under a line of the robot, DEM frame [m].
struct SlicePoint {
    TruthLine line = TruthLine::LeftTrack;
    double x = 0.0, z = 0.0;
    bool operator==(const SlicePoint&) const = default;
};

inline constexpr std::size_t kMaxCellPoints = 12;  ///< of a cell in a slice
/// Part of the DEM frame that a slice shows [m]: the bins, and the robot with raised flippers.
inline constexpr double kSliceRear = -0.82, kSliceFront = 0.9;
inline constexpr double kSliceBottom = -0.8, kSliceTop = 0.4;

/// Returns the slice of a place with this correction. It has the points under the tracks up to +0.25 m, and beyond it
/// those under the flippers. Points of a cell lie side by side.
std::vector<SlicePoint> truthSlice(const SceneGrid& grid, const RobotModel& robot,
                                   std::size_t place, const CloudCorrection& correction);

/// Returns the slice of a scene. Empty without a pose or a grid.
std::vector<SlicePoint> truthSlice(const LaserTruth& truth, std::size_t row);

}  // namespace terratact
