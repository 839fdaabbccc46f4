#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/robot/kinematics.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// An axle's flippers held at an angle.  A load beyond the motors' torque moves them all the same.
struct HoldAngle {
    double angle = 0.0;  ///< [rad]
};
/// An axle's flippers pressed by a torque until something holds them, or until kLowestFlipper.
struct PressTorque {
    double torque = 0.0;      ///< [N m] both flippers together, pressing down positive
    double startAngle = 1.0;  ///< [rad] where the descent begins
};
using FlipperDrive = std::variant<HoldAngle, PressTorque>;

/// Pressed flippers that find no ground are stopped and held here [rad].
inline constexpr double kLowestFlipper = -1.2;

/// A force between ground and robot.
struct GroundContact {
    enum class Part { Track, Front, Rear, Body };
    Part part = Part::Track;
    Vec2 point;          ///< terrain's frame [m]
    Vec2 force;          ///< on the robot [N]
    double depth = 0.0;  ///< [m] by which the skin is compressed
};

struct RestPose {
    Pose pose;  ///< base in the terrain's frame
    std::vector<GroundContact> contacts;
    double energy = 0.0;       ///< [J] at the minimum
    double frontTorque = 0.0;  ///< [N m] motors of both front flippers, pressing down positive
    double rearTorque = 0.0;   ///< [N m]
    FlipperDrive front,
        rear;  ///< in effect: a held axle that gave way is pressed by its motors' limit, a
               ///< pressed one that found no ground is held at kLowestFlipper
    int iterations = 0;
    std::size_t terrainPoints =
        0;  ///< how often a point of the ground was sampled or held against a part
};

/// Ground and solver constants.  A spring stands at every point of the terrain's line sampled at `spacing`;
/// between two of them a part of radius r sinks spacing²/8r deeper (0.1 mm for the flippers' tip), which
/// the skin takes up, so that the body itself stays above the ground.
struct GroundOptions {
    double spacing = 0.005;  ///< [m]
    double skin = 2e-4;      ///< [m] thickness of the compressible skin around the robot
    double stiffness = 5e6;  ///< [N/m] per point
    /// [m] of soft ground on top of firm ground; less than the least radius of the robot's parts.
    double softLayer = 0.0;
    double softStiffness = 0.0;  ///< [N/m] per point, of the soft layer
};

/// Potential energy [J] of a pose: weight, flipper torques (τ·angle) and the compressed skin,
///   E = Σ m g z + τ_front θ_front + τ_rear θ_rear + ½ Σ (k_soft depth² + k max(0, depth − softLayer)²).
/// depth: how deep a point of the ground lies in a part's skin.  k_soft: of the soft layer, if there is one.
/// A held flipper has no torque term.
double potentialEnergy(const RobotModel& robot, const TerrainProfile& terrain, const Pose& pose,
                       const FlipperDrive& front, const FlipperDrive& rear,
                       const GroundOptions& ground = {});

/// The pose a robot rests in with its base origin at x: the local minimum of potentialEnergy over
/// height, pitch and the pressed flippers' angles that is reached by lowering the robot from
/// `startPitch` onto the ground, contacts growing stiffer (x itself is held by friction).
/// Domain: a robot at rest minimises its potential energy over terrain it cannot enter; the contact
/// forces are the forces of stiff one-sided springs.
/// A held axle that would need more than its motors' torque gives way (see RestPose::rear).
/// Error when there is no rest pose: it tips over (|pitch| > 1.2 rad), or a flipper lies on the robot (beyond 2.5 rad),
/// be it held there or pushed there because its motors cannot hold the robot.
Result<RestPose> restPose(const RobotModel& robot, const TerrainProfile& terrain, double x,
                          const FlipperDrive& front, const FlipperDrive& rear,
                          double startPitch = 0.0, const GroundOptions& ground = {});

/// Forces the six elements of one front flipper feel [N]: the normal forces on its lower edge shared
/// between the two nearest elements as a beam on supports shares a load; half of the axle's load each.
/// Forces on the pivot circle, which carries no sensor, are left out.  Not saturated.
std::array<double, kForceElements> elementForces(const RobotModel& robot, const RestPose& rest);

/// Exact readings of the proprioceptive sensors at a rest pose.
Proprioception exactReadings(const RobotModel& robot, const RestPose& rest);

}  // namespace terratact
