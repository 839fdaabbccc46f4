#pragma once

#include <cmath>
#include <variant>

namespace terratact {

/// Flippers held at an angle. A load beyond their motors' torque still moves them.
struct HoldAngle {
    double angle = 0.0;  ///< [rad]
};
/// Flippers pressed by a torque until something holds them, or until kLowestFlipper.
struct PressTorque {
    /// [N m] pressing down positive, of both flippers of an axle. It is of one flipper where a
    /// function takes a drive for each.
    double torque = 0.0;
    double startAngle = 1.0;  ///< start of the descent [rad]
};
using FlipperDrive = std::variant<HoldAngle, PressTorque>;

/// Pressed flippers that find no ground are stopped and held here [rad].
inline constexpr double kLowestFlipper = -1.2;
/// Beyond this angle [rad] a flipper lies on the robot.
inline constexpr double kMaxFlipper = 2.5;

inline bool isPressed(const FlipperDrive& drive)
{
    return std::holds_alternative<PressTorque>(drive);
}

/// Returns the pressing torque [N m]; 0 for a held flipper.
inline double torqueOf(const FlipperDrive& drive)
{
    const auto* press = std::get_if<PressTorque>(&drive);
    return press ? press->torque : 0.0;
}

/// Returns the angle [rad] at which the search for a rest pose begins.
inline double startAngle(const FlipperDrive& drive)
{
    if (const auto* hold = std::get_if<HoldAngle>(&drive)) return hold->angle;
    return std::get<PressTorque>(drive).startAngle;
}

inline bool isFinite(const FlipperDrive& drive)
{
    return std::isfinite(startAngle(drive)) && std::isfinite(torqueOf(drive));
}

/// Returns true for a flipper that is held where it lies on the robot.
inline bool isFolded(const FlipperDrive& drive)
{
    return !isPressed(drive) && std::abs(startAngle(drive)) > kMaxFlipper;
}

/// Returns the drive of motors with this torque limit [N m] that have to supply `torque`. A held
/// flipper that needs more gives way: it is pressed by the limit.
inline FlipperDrive sustained(const FlipperDrive& drive, double torque, double limit)
{
    const bool overloaded = !isPressed(drive) && std::abs(torque) > limit;
    return overloaded ? FlipperDrive{PressTorque{std::copysign(limit, torque), startAngle(drive)}}
                      : drive;
}

}  // namespace terratact
