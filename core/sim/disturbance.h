#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/robot/robot_model.h"
#include "core/sim/drive.h"

namespace terratact {

/// What the simulated world does that the estimator does not know of, for tests of robustness.
///   ImuNoise      pitch noise of 1° instead of 0.5°
///   ForcesHigh    every force reads 25 % high; ForcesLow: 25 % low
///   DeadElement   element 4 always reads 0
///   SoftGround    the robot sinks about 2 cm into flat ground.  The truth stays the surface that a scanner
///                 sees, which then lies above the robot's lower edge: the ceiling no longer holds.
///   LightRobot    every mass 20 % less; HeavyRobot: 20 % more
///   FrictionFree  nothing holds x: the robot slides up to 5 cm towards less energy before it is measured.
///                 Contacts carry normal forces only in any case (core/sim/rest_pose.h).
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

/// "none", "imu-noise", "forces-high", "forces-low", "dead-element", "soft-ground", "light-robot",
/// "heavy-robot", "friction-free".
std::string_view name(Disturbance disturbance);
std::optional<Disturbance> disturbanceFromName(std::string_view text);

/// The same, changed by the disturbance; unchanged where it is about something else.
SensorNoise disturbed(SensorNoise noise, Disturbance disturbance);
GroundOptions disturbed(GroundOptions ground, Disturbance disturbance);
RobotModel disturbed(RobotModel robot, Disturbance disturbance);

/// What the sensors report in place of s; forces stay within 0 and `saturation` [N].
Proprioception disturbed(Proprioception s, double saturation, Disturbance disturbance);

/// All of a drive but the robot: noise, ground, readings and sliding.  saturation: [N], of the elements.
DriveConditions disturbedDrive(const SensorNoise& noise, double saturation,
                               Disturbance disturbance);

}  // namespace terratact
