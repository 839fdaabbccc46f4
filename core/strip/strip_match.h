#pragma once

#include <span>

#include "core/robot/robot_model.h"
#include "core/strip/pose_covariance.h"

namespace terratact {

/// A column that is in both the strip and a new estimate.
struct MatchedBin {
    double difference = 0.0;  ///< [m] the strip's height minus the estimate's, by odometry
    double slope = 0.0;       ///< of the ground there
    double variance = 0.0;    ///< [m²] of the difference, without the pose's error
};

/// Correction of a pose, and its uncertainty.
struct PoseOffset {
    Vec2 mean;  ///< [m]
    PoseCovariance covariance;
};

/// Returns the error e of odometry since the last scene. It comes from its prior N(0, `prior`) and
/// the ground that is in both scenes:
///   difference = e_z − slope · e_x + error
/// Errors of neighbouring bins and of successive estimates are correlated. Each bin therefore counts as
/// 1 / kCorrelatedBins of an independent one. Bins that differ by more than kHuber sd count less (Huber's weights).
PoseOffset matched(const PoseCovariance& prior, std::span<const MatchedBin> bins);

inline constexpr double kCorrelatedBins = 2.0;
inline constexpr double kHuber = 1.5;

}  // namespace terratact
