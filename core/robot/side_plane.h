#pragma once

#include <optional>

#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"

namespace terratact {

// One side of a robot with two tracks, seen as a robot on one plane. The functions for one plane
// (ceilings, contacts, felt bins) then hold for the side's vertical plane.

/// Returns the robot whose poseInDem() is the pose of a vertical plane along the robot. Only the
/// IMU's place differs:
///   z' = z cos φ − sideLift(y, φ).
/// The base therefore lies as in sidePose() with a locked differential. y: signed [m], left positive.
/// roll φ: [rad]. The DEM frame keeps its origin: the robot's IMU.
RobotModel inSidePlane(const RobotModel& robot, double roll, double y);

/// Returns the readings of one side: its flippers' angles, currents and front forces, and the pitch.
Proprioception sideReadings(const TwoTrackReadings& s, Side side);

/// Returns the readings of one plane: proprioception() of the line of telemetry with these readings.
Proprioception planeReadings(const TwoTrackReadings& s);

/// Returns true if the sides differ by more than kSymmetricSd standard deviations of the noise
/// (core/sim/sensor_noise.h). Compared are roll, angles, differential, and the currents and front
/// forces that both sides have; a reading that one side alone has does not count.
bool sidesDiffer(const TwoTrackReadings& s);

/// Returns true if the sides do not differ, and no current or front force is of one side alone.
bool isSymmetric(const TwoTrackReadings& s);
inline constexpr double kSymmetricSd = 3.0;

/// Returns true if a track differential has turned: by more than kTurnedDifferential, which is beyond
/// its sensor's noise. If it has, the tracks' pitches differ. Empty: it is locked.
bool hasTurned(const std::optional<double>& differential);
inline constexpr double kTurnedDifferential = 0.02;  // [rad]

}  // namespace terratact
