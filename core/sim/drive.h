#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/robot/robot_model.h"
#include "core/sim/rest_pose.h"
#include "core/sim/sensor_noise.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Flippers during one drive.
struct DriveStyle {
    double rearAngle = 0.2;     ///< [rad] held
    double pressTorque = 18.0;  ///< [N m] both front flippers
    double drivingAngle = 0.7;  ///< [rad] front flippers between the stops
};

/// Rear flippers −15° … 40°, press torque 12 … 24 N m.
DriveStyle randomDriveStyle(std::mt19937_64& rng);

/// Sensors and ground during one drive.
struct DriveConditions {
    SensorNoise noise{};
    GroundOptions ground{};
    /// What becomes of a noisy reading before it is recorded; empty: nothing.
    std::function<Proprioception(const Proprioception&)> reading{};
    double slide =
        0.0;  ///< [m] at a stop the robot slides at most so far towards less energy; 0 where
              ///< friction holds it
};

/// Ground that gives way: a soft layer of 12 … 28 mm with 60 … 240 N/m per point, so that the robot sinks
/// some 1 … 2.5 cm into flat ground.
GroundOptions randomSoftGround(std::mt19937_64& rng);

/// Base positions x [m] at which a drive over the terrain stops for a measurement: every `spacing`, as
/// long as the robot and its bins stay over the terrain; one position, with bin −0.3 on the terrain's
/// first point, where the terrain is too short for that.
std::vector<double> stopsOver(const TerrainProfile& terrain, double spacing);

/// Drives over the stops in order and measures a scene at each: the front flippers are pressed down
/// from above, the robot rests (after sliding, if conditions.slide lets it), sensors are read with
/// conditions.noise, and the reading goes through conditions.reading.  The truth carries the scanner's
/// noise unless noise.height is 0.  Stops without a rest pose are left out and counted in `skipped`.
std::vector<Scene> driveOver(const RobotModel& robot, const TerrainProfile& terrain,
                             const std::vector<double>& stops, const std::string& run,
                             const DriveStyle& style, const DriveConditions& conditions,
                             std::mt19937_64& rng, int& skipped);

/// What tracks and IMU say.
struct OdometryReading {
    double travelled = 0.0;  ///< [m] since the drive's start, with slip
    double pitch = 0.0;      ///< [rad] with noise
};

struct DrivenScene {
    Scene scene;
    /// From the scene before, or the drive's start, to this one: the flippers come up, the robot drives, and the
    /// flippers go down.  The last is of this scene itself.
    std::vector<OdometryReading> way;
};

/// driveOver with what odometry says between the stops: at the first stop, and then every 5 cm at most, the robot
/// rests with its front flippers held up, as SimulatedRobot drives.  The tracks roll off trackWay, and report
/// (1 + e) times that, e ~ N(0, slipShare²) drawn anew at every stop.  rng, and its sequence, are not driveOver's.
std::vector<DrivenScene> driveWithOdometry(const RobotModel& robot, const TerrainProfile& terrain,
                                           const std::vector<double>& stops, const std::string& run,
                                           const DriveStyle& style,
                                           const DriveConditions& conditions, double slipShare,
                                           std::mt19937_64& rng, int& skipped);

}  // namespace terratact
