#pragma once

#include <random>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Standard deviations of the simulated sensors.
struct SensorNoise {
    double pitch = 0.0087;         ///< 0.5°, the static accuracy of an MTi [rad]
    double flipperAngle = 0.0017;  ///< [rad] 0.1°
    double current = 0.05;         ///< [A] assumed
    double forceShare = 0.10;      ///< share of the force
    double forceFloor = 0.3;       ///< [N]
    double height = 0.012;         ///< noise of the scanner that gives the training truth [m]

    static SensorNoise none() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }
};

/// Returns readings with Gaussian noise. The variance of a force is
///   (forceShare · force)² + forceFloor².
/// The force stays within 0 and `saturation` [N], a current within ±kMaxSceneCurrent of a scene
/// (core/learn/data/columns.h). Features that were not measured stay empty.
/// Throws std::invalid_argument for a negative standard deviation or saturation ≤ 0.
Proprioception noisy(const Proprioception& exact, const SensorNoise& noise, double saturation,
                     std::mt19937_64& rng);

/// Returns the same for readings of both sides. Roll has the noise of pitch, and the differential that
/// of a flipper's angle.
TwoTrackReadings noisy(const TwoTrackReadings& exact, const SensorNoise& noise, double saturation,
                       std::mt19937_64& rng);

/// Returns the forces of both sides for means of measurement.force, on ground that loads both sides equally. Each is
/// the mean plus or minus a difference with the noise of a mean. It stays within 0 and the saturation. A mean beyond
/// them is that of both sides. An element on one side only reads the mean. Elements that the robot lacks or that are
/// missing are empty.
SideForces sidesOf(const Measurement& measurement, const SensorNoise& noise,
                   const RobotModel& robot, std::mt19937_64& rng);

/// Returns the terrain as the scanner reports it.
Heights noisy(const Heights& exact, const SensorNoise& noise, std::mt19937_64& rng);

}  // namespace terratact
