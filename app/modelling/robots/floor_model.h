#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"

namespace terratact {

/// What a calibration on a flat floor estimates. Lengths are those of the robot file; the others are errors of sensors.
struct FloorParameter {
    enum : std::size_t {
        TrackAxle,                        ///< [m]
        FrontLength,                      ///< [m] axle distance of the front flippers
        RearLength,                       ///< [m]
        FrontTip,                         ///< [m] tip radius
        RearTip,                          ///< [m]
        Encoders,                         ///< [rad] reading − angle, four in the order of Flipper
        ImuPitch = Encoders + kFlippers,  ///< [rad] reading − pitch
        ImuRoll,                          ///< [rad]
        ImuYaw,  ///< [rad] the sensor's x axis is turned to the left: roll reads −yaw · sin(pitch)
        Count
    };
};
using FloorParameters = Eigen::Matrix<double, FloorParameter::Count, 1>;

/// Returns the parameters that a robot file assumes: sensors without error.
FloorParameters parametersOf(const RobotModel& robot);
/// Returns the robot with the lengths of these parameters.
RobotModel withParameters(RobotModel robot, const FloorParameters& parameters);

/// How a robot rests on a flat, level floor at given flipper angles. It stands on two circles, of
/// wheels, pivots and tips. All others lie above their common lower tangent, and its centre of mass
/// is between them.
struct FloorRest {
    double pitch = 0.0;               ///< [rad] nose up
    std::array<double, 2> support{};  ///< [m] rear and front contact, along the floor
    double mass = 0.0;                ///< [m] centre of mass, along the floor
    double floor = 0.0;               ///< [m] height of the floor, in axes through the base origin
    bool onFrontTip = false, onRearTip = false;
    /// [N m] both motors of the axle, pressing down positive, where its tips carry the robot; else 0.
    double frontTorque = 0.0, rearTorque = 0.0;
};
/// Returns empty if the robot tips over. front, rear: [rad].
std::optional<FloorRest> restOnFloor(const RobotModel& robot, double front, double rear);

/// Returns the height of one flipper's tip above the floor at a rest [m].
double tipAboveFloor(const FloorRest& rest, const FlipperGeometry& flipper, double angle);

}  // namespace terratact
