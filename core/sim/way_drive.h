#pragma once

#include <random>
#include <string>

#include "core/learn/data/drive_lines.h"
#include "core/robot/robot_model.h"
#include "core/sim/drive.h"
#include "core/terrain/ground_lines.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Stops, telemetry and odometry of a drive with lines on the way.
struct WayDriveOptions {
    double spacing = 0.0;      ///< [m] between two stops; 0: one random spacing of the drive
    double step = 0.03;        ///< [m] largest distance of two lines on the way
    double slipShare = 0.10;   ///< sd of the slip as a share of the way
    double driveSlip = 0.0;    ///< sd of the odometry's relative error common to the drive
    double pitchBias = 0.0;    ///< [rad] added to every reading of pitch
    double pressShare = 1.0;   ///< share of stops at which the robot presses
    double pressTorque = 0.0;  ///< [N m] both front flippers; 0: style.pressTorque
    double gap = 0.0;          ///< [s] of telemetry lost once per drive; 0: none
};

/// Range of the random spacing between two stops [m].
inline constexpr double kMinWaySpacing = 0.08, kMaxWaySpacing = 0.35;

/// Durations of lowering the flippers to the ground, and of raising them again [s]. No line of
/// telemetry falls into them. A line follows within kMaxSilence.
inline constexpr double kPressingTime = 0.8, kRaisingTime = 0.8;

/// Drives over the terrain along stopsOver(), from the first stop to the last. Every line of the way is
/// the rest pose with the front flippers at style.drivingAngle. The search for it begins at the
/// attitude of the line before. At a stop follows a scene with pressed flippers and the true heights.
/// Its base x and its odometry are those of the line before. A stop without a press has no scene.
///   travelled   (1 + common) Σ (1 + slip) trackWay();  slip ~ N(0, slipShare²), drawn again after
///               each stop;  common ~ N(0, driveSlip²), drawn once per drive
///   time        way along x / kDriveSpeed, plus the durations above
/// Readings have conditions.noise, and so has the truth unless noise.height is 0. The gap erases
/// every line in a random interval. driveSlip changes `travelled` alone. Positions without a rest
/// pose have no line; stops with a press and without a rest pose count in `skipped`. Throws
/// std::invalid_argument if spacing, slipShare, driveSlip, pressTorque or gap is negative, or step is
/// not above 0. It does so, too, if pressShare is not within 0 … 1, or other conditions than noise and
/// ground are set.
DriveLines driveWay(const RobotModel& robot, const TerrainProfile& terrain, const std::string& run,
                    const DriveStyle& style, const WayDriveOptions& options,
                    const DriveConditions& conditions, std::mt19937_64& rng, int& skipped);

/// Drives on two tracks in the same way. The truth is sideHeights() of each side.
DriveLines driveWay(const RobotModel& robot, const GroundLines& terrain, const std::string& run,
                    const DriveStyle& style, const WayDriveOptions& options,
                    const DriveConditions& conditions, std::mt19937_64& rng, int& skipped);

}  // namespace terratact
