#pragma once

#include <cstdint>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Where a robot at rest tips over [rad], on ground along its tracks: its centre of mass then stands above the last
/// point that carries it.  From the masses of the robot file and the flippers' angles.
struct TipOver {
    double noseUp =
        0.0;  ///< over the tracks' rear end, or the rear flippers' tips where they lie as low
    double noseDown = 0.0;  ///< over the front
    double side = 0.0;      ///< over RobotModel::halfWidth
};
TipOver tipOver(const RobotModel& robot, double front, double rear);

/// How near an angle is to tipping over, or how far beyond what the operator wants.
enum class AttitudeLevel : std::uint8_t { Level, Amber, Red };

/// The operator's own limits of |pitch| and |roll| [rad].
struct AttitudeLimits {
    double amber = 0.4363;  ///< 25°
    double red = 0.6109;    ///< 35°
    bool operator==(const AttitudeLimits&) const = default;
};

/// Nearer to tipping over than this is amber, or red [rad]: 20° and 10°.  Ground gives way, and a drive brakes.
inline constexpr double kAmberReserve = 0.3491, kRedReserve = 0.1745;

struct Attitude {
    AttitudeLevel pitch = AttitudeLevel::Level, roll = AttitudeLevel::Level;
    double pitchTips = 0.0,
           rollTips = 0.0;  ///< [rad] where it tips over that way, with the sign of the angle
    AttitudeLevel worst() const { return pitch > roll ? pitch : roll; }
    bool operator==(const Attitude&) const = default;
};

/// Red from the smaller of limits.red and tip-over − kRedReserve on, amber from the smaller of limits.amber and
/// tip-over − kAmberReserve.
Attitude attitudeOf(const Measurement& line, const RobotModel& robot, const AttitudeLimits& limits);

}  // namespace terratact
