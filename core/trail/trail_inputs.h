#pragma once

#include <Eigen/Core>

#include "core/robot/measurement.h"
#include "core/robot/two_tracks.h"
#include "core/terrain/bins.h"
#include "core/trail/trail_history.h"

namespace terratact {

/// Scale of a clearance as input [m].
inline constexpr double kTrailClearance = 0.02;

/// Stands for the ceiling of a bin that the robot does not cover [m].
inline constexpr double kTrailOpenCeiling = 0.3;

/// Returns the inputs of the networks of one plane, in this order:
///   11  s, forces as in surfaceFeatures() (core/learn/model/surface_rows.h)
///   10  pitch along the way
///    9  asinh((ceiling − lowest) / kTrailClearance); 0 where `lowest` is not below the ceiling
///    9  log(1 + load / 3 N)
///    9  asinh((ceiling − pressed) / kTrailClearance); 0 without load
///    1  way
///   11  1 where the robot does not cover the bin, else 0
/// ceiling: of the scene. Throws std::invalid_argument if s lacks a feature.
Eigen::VectorXd planeInputs(const Proprioception& s, const TrailHistory& history,
                            const Heights& ceiling);
inline constexpr Eigen::Index kPlaneInputs = 60;

/// Returns the inputs of the networks of one side. They are those of planeInputs(), with the side's
/// features (core/learn/data/side_features.h) as s, and the side's own plane of the history. After
/// the pitch, 10 inputs give the roll along the way, own side up positive. A mirrored scene has
/// mirrored inputs.
Eigen::VectorXd sideInputs(const TwoTrackReadings& s, Side own, const TrailHistory& history,
                           const Heights& ceiling);
inline constexpr Eigen::Index kSideInputs = 81;

}  // namespace terratact
