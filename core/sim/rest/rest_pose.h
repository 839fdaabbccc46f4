#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/robot/kinematics.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/sim/rest/flipper_drive.h"
#include "core/sim/rest/ground_contact.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

struct RestPose {
    Pose pose;  ///< base in the terrain's frame
    std::vector<GroundContact> contacts;
    double energy = 0.0;       ///< [J] at the minimum
    double frontTorque = 0.0;  ///< [N m] motors of both front flippers, pressing down positive
    double rearTorque = 0.0;   ///< [N m]
    /// Effective drives. A held axle that gave way is pressed by its motors' limit. A pressed axle
    /// that found no ground is held at kLowestFlipper.
    FlipperDrive front, rear;
    int iterations = 0;
    /// Number of ground points that were sampled or compared with a part.
    std::size_t terrainPoints = 0;
};

/// Returns the rest pose with the base origin at x. It is a local minimum of the potential energy
/// over height, pitch and the pressed flippers' angles. The robot reaches it when it is lowered from
/// `startPitch` with growing contact stiffness. Friction holds x.
/// The potential energy [J] is that of weight, flipper torques (τ·angle) and the compressed skin:
///   E = Σ m g z + τ_front θ_front + τ_rear θ_rear + ½ Σ (k_soft depth² + k max(0, depth − softLayer)²)
/// depth: how deep a point of the ground lies in a part's skin. k_soft: stiffness of the soft
/// layer, if there is one. A held flipper has no torque term.
/// Model: a robot at rest minimises its potential energy over terrain that it cannot enter. The
/// contact forces are the forces of stiff one-sided springs. A held axle that needs more than its
/// motors' torque gives way (RestPose::front, rear).
/// Error if there is no rest pose. The robot tips over (|pitch| > 1.2 rad), or a flipper lies on
/// the robot (beyond 2.5 rad). It may be held there, or pushed there by an overload of its motors.
Result<RestPose> restPose(const RobotModel& robot, const TerrainProfile& terrain, double x,
                          const FlipperDrive& front, const FlipperDrive& rear,
                          double startPitch = 0.0, const GroundOptions& ground = {});

/// Returns the forces on the six elements of one front flipper [N]. The two nearest elements share
/// a normal force on the lower edge like the supports of a beam. Each flipper has half of the
/// axle's load. Forces on the pivot circle, which has no sensor, are ignored. Not saturated.
std::array<double, kForceElements> elementForces(const RobotModel& robot, const RestPose& rest);

/// Returns the exact readings of the proprioceptive sensors at a rest pose.
Proprioception exactReadings(const RobotModel& robot, const RestPose& rest);

}  // namespace terratact
