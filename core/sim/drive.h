#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/ground_lines.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

inline constexpr double kDriveSpeed = 0.3;  ///< [m/s] between the stops of a drive

/// Returns heights of which all are known.
OptionalHeights known(const Heights& heights);

/// Flipper settings of one drive.
struct DriveStyle {
    double rearAngle = 0.2;     ///< [rad] held
    double pressTorque = 18.0;  ///< [N m] both front flippers
    double drivingAngle = 0.7;  ///< front flippers between the stops [rad]
};

/// Returns a random style: rear flippers −15° … 40°, press torque 12 … 24 N m.
DriveStyle randomDriveStyle(std::mt19937_64& rng);

/// Sensors and ground of one drive.
struct DriveConditions {
    SensorNoise noise{};
    GroundOptions ground{};
    /// Changes a noisy reading before it is recorded; empty: no change.
    std::function<Proprioception(const Proprioception&)> reading{};
    /// Receives the rest pose of every scene, before its readings get their noise; empty: nobody does.
    std::function<void(const RestPose&)> rested{};
    /// The same of a robot with two tracks.
    std::function<void(const TwoTrackPose&)> stood{};
    /// Largest slide at a stop towards less energy [m]; 0: friction holds the robot.
    double slide = 0.0;
};

/// Returns soft ground: a layer of 12 … 28 mm with 60 … 240 N/m per point. The robot sinks about 1
/// … 2.5 cm into flat ground.
GroundOptions randomSoftGround(std::mt19937_64& rng);

/// Returns the base positions x [m] at which a drive over the terrain stops for a measurement. They
/// are `spacing` apart, as long as the robot and its bins stay over the terrain. A terrain that is
/// too short gives one position, with bin −0.3 on its first point.
std::vector<double> stopsOver(const TerrainProfile& terrain, double spacing);
/// Returns the same over the x that all lines of a ground cover.
std::vector<double> stopsOver(const GroundLines& terrain, double spacing);

/// Drives over the stops in order and measures a scene at each. The front flippers are pressed down
/// from above, and the robot rests, after sliding if conditions.slide allows it. Sensors are read
/// with conditions.noise and conditions.reading. The truth has the scanner's noise unless
/// noise.height is 0. Stops without a rest pose are skipped and counted in `skipped`.
std::vector<Scene> driveOver(const RobotModel& robot, const TerrainProfile& terrain,
                             const std::vector<double>& stops, const std::string& run,
                             const DriveStyle& style, const DriveConditions& conditions,
                             std::mt19937_64& rng, int& skipped);

}  // namespace terratact
