#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/robot/robot_model.h"
#include "core/sim/drive.h"

namespace terratact {

/// Disturbance of the simulated world that the estimator does not model, for robustness tests.
///   ImuNoise      pitch noise of 1° instead of 0.5°
///   ForcesHigh    every force reads 25 % high; ForcesLow: 25 % low
///   DeadElement   element 4 always reads 0
///   SoftGround    the robot sinks about 2 cm into flat ground. The truth stays the surface that a scanner
///                 sees. It lies above the robot's lower edge, so that the ceiling does not hold.
///   LightRobot    every mass 20 % less; HeavyRobot: 20 % more
///   FrictionFree  nothing holds x: the robot slides up to 5 cm towards less energy before it is measured.
///                 Contacts always carry normal forces only (core/sim/rest/rest_pose.h).
enum class Disturbance : std::uint8_t {
    None,
    ImuNoise,
    ForcesHigh,
    ForcesLow,
    DeadElement,
    SoftGround,
    LightRobot,
    HeavyRobot,
    FrictionFree,
};

inline constexpr std::array kDisturbances{
    Disturbance::None,       Disturbance::ImuNoise,    Disturbance::ForcesHigh,
    Disturbance::ForcesLow,  Disturbance::DeadElement, Disturbance::SoftGround,
    Disturbance::LightRobot, Disturbance::HeavyRobot,  Disturbance::FrictionFree};

/// Returns "none", "imu-noise", "forces-high", "forces-low", "dead-element", "soft-ground",
/// "light-robot", "heavy-robot" or "friction-free".
std::string_view name(Disturbance disturbance);
std::optional<Disturbance> disturbanceFromName(std::string_view text);

/// Return the argument with the disturbance applied; unchanged if the disturbance concerns
/// something else.
SensorNoise disturbed(SensorNoise noise, Disturbance disturbance);
GroundOptions disturbed(GroundOptions ground, Disturbance disturbance);
RobotModel disturbed(RobotModel robot, Disturbance disturbance);

/// Returns the reported readings in place of s; forces stay within 0 and `saturation` [N].
Proprioception disturbed(Proprioception s, double saturation, Disturbance disturbance);

/// Returns all conditions of a drive but the robot: noise, ground, readings and sliding.
/// saturation: of the elements [N].
DriveConditions disturbedDrive(const SensorNoise& noise, double saturation,
                               Disturbance disturbance);

}  // namespace terratact
