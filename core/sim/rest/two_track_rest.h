#pragma once

#include "core/base/result.h"
#include "core/robot/two_tracks.h"
#include "core/sim/rest/flipper_drive.h"
#include "core/sim/rest/two_track_potential.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Larger roll at rest [rad] means that the robot tips over sideways.
inline constexpr double kMaxRestRoll = 0.7;

/// Rest pose of a robot with two tracks.
struct TwoTrackRest {
    TwoTrackPose pose;             ///< base in the terrain's frame
    SideContacts contacts;         ///< left, right
    double energy = 0.0;           ///< [J] at the minimum
    PerFlipper<double> torques{};  ///< [N m] of each flipper's motor, pressing down positive
    /// Effective drives. A held flipper that gave way is pressed by its motor's limit. A pressed
    /// flipper that found no ground is held at kLowestFlipper.
    PerFlipper<FlipperDrive> drives{};
    PerFlipper<bool> hangs{};    ///< pressed, and found no ground: nothing is felt there
    PerFlipper<bool> gaveWay{};  ///< held, and moved by a load beyond its motor's torque
    bool differentialAtLimit = false;
    int iterations = 0;
    /// Number of ground points that were sampled or compared with a part.
    std::size_t terrainPoints = 0;
};

/// Attitude from which the search for a rest pose begins. On ground with several stable rolls, the
/// previous roll leads to the one that the robot keeps.
struct RestStart {
    double pitch = 0.0, roll = 0.0;  ///< [rad]
};

/// Returns drives of single flippers for drives of axles: each flipper has half of a torque.
PerFlipper<FlipperDrive> flipperDrives(const FlipperDrive& front, const FlipperDrive& rear);

/// Returns the rest pose with the base origin at x. It is a local minimum of TwoTrackPotential
/// over height, pitch, roll, the pressed flippers' angles and a free differential. The robot
/// reaches it when it is lowered from `start` with growing contact stiffness. On equal lines it is
/// restPose() of the plane (core/sim/rest/rest_pose.h). drives: torques of single flippers. Error
/// if there is no rest pose. The robot tips over (|pitch| > 1.2 rad or |roll| > 0.7 rad). Or a
/// flipper lies on the robot (beyond 2.5 rad). Throws std::invalid_argument unless all numbers are
/// finite.
Result<TwoTrackRest> restPose(const RobotModel& robot, const GroundLines& terrain, double x,
                              const PerFlipper<FlipperDrive>& drives, const RestStart& start = {},
                              const GroundOptions& ground = {});

/// Returns the exact readings at a rest pose. Forces are those of the robot's force arrays, saturated;
/// rear forces exist if the robot has rear elements.
TwoTrackReadings exactReadings(const RobotModel& robot, const TwoTrackRest& rest);

}  // namespace terratact
