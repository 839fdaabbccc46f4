#pragma once

#include <string>

#include "app/modelling/truth/laser_truth.h"

namespace terratact {

/// Returns lines for the terminal: points, scenes with heights, scenes without heights and the
/// reasons, and offset and tilt between cloud and robot. Errors are relative to the file's earlier heights.
std::string truthReport(const LaserTruth& truth, const LaserTruthOptions& options);

/// Returns why no bin has a known height, and what to do. The cloud is too sparse under the scenes, the height between
/// robot and cloud is too uncertain, or another reason.
std::string noHeightsText(const LaserTruth& truth);

/// Returns a CSV with a row for each bin of a scene with a pose:
///   run, t_s, side (left, right or both), bin_m, height_m, sd_m, points, cells
/// height_m and sd_m are empty if the cloud gives no height.
std::string truthSupportCsv(const LaserTruth& truth);

/// Returns the scenes with the heights of the cloud, as CSV of the kind that was read.
std::string truthScenesCsv(const LaserTruth& truth);

}  // namespace terratact
