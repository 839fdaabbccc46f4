#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/poll.h"
#include "core/learn/data/drive_lines.h"
#include "core/learn/net/network_training.h"
#include "core/robot/robot_model.h"
#include "core/trail/trail_model.h"

namespace terratact {

/// Training rows of the networks, one column each. One plane has a column per scene. Two tracks have the left and then
/// the right side of each scene.
struct TrailRows {
    Eigen::MatrixXf inputs;    ///< planeInputs() or sideInputs()
    Eigen::MatrixXd heights;   ///< 11 × n [m]; 0 where they are unknown
    Eigen::MatrixXf weights;   ///< 11 × n, trailWeight() of each height; 0 where it is unknown
    Eigen::MatrixXd ceilings;  ///< 11 × n [m], +infinity where the robot does not cover the bin
    std::vector<unsigned> covered;  ///< covered bins
    std::vector<int> drive;         ///< number of the drive
    int leftOut = 0;                ///< scenes that lack a feature or every height
};

/// Error of the networks on exact heights [m], rounded (docs/memory.md).
inline constexpr double kTrailSpread = 0.02;

/// Returns the weight of a height with the sd s [m] in the loss and the scales: kTrailSpread² / (kTrailSpread² + s²).
double trailWeight(double s);

/// Share of the training scenes that know only a part of their way. They train the networks for a
/// shortened memory.
inline constexpr double kCutShare = 0.25;

/// One drive of so many is not trained on and gives the errors.
inline constexpr int kErrorDrives = 10;

/// Returns the rows of drives. number: of the first drive. sides: of both sides. For a share kCutShare of the scenes,
/// only a uniform random part of the way is known. Drives that give the errors are not cut. Equal drives and seeds give
/// equal rows. poll: called for each drive.
TrailRows trailRows(std::span<const DriveLines> drives, int number, const RobotModel& robot,
                    bool sides, std::uint64_t seed, const Poll& poll = {});

/// Returns the rows of all parts, in the order of the parts.
TrailRows joined(std::span<const TrailRows> parts);

/// Size of a training.
struct TrailOptions {
    int networks = 5;  ///< of different seeds
    NetworkOptions network{};
};

/// Trains the networks on all drives but every kErrorDrives-th, whose scenes with all heights give the errors. sides:
/// rows of both sides. sideBySide: runs the networks' trainings in parallel; empty: one after the other. The
/// result is the same. Throws std::invalid_argument for too few rows, or too few scenes with all
/// heights for the errors.
TrailNetworks trainTrail(const TrailRows& rows, bool sides, const TrailOptions& options,
                         const ForEach& sideBySide = {}, const Poll& poll = {});

}  // namespace terratact
