#pragma once

#include <cstdint>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Tip-over angles [rad] of a robot at rest, on ground along its tracks. At these angles its centre
/// of mass stands above the last point of support. They follow from the masses in the robot file
/// and the flippers' angles.
struct TipOver {
    double noseUp = 0.0;  ///< over the tracks' rear end, or over the tips of lowered rear flippers
    /// Over the tracks' front end, or over the tips of lowered front flippers.
    double noseDown = 0.0;
    double leftUp = 0.0;   ///< over the right track's outer edge, RobotModel::halfWidth away
    double rightUp = 0.0;  ///< over the left track's outer edge; the body may be off-centre
};
TipOver tipOver(const RobotModel& robot, double front, double rear);

/// Warning level of an angle: distance from tipping over, and from the operator's limits.
enum class AttitudeLevel : std::uint8_t { Level, Amber, Red };

/// The operator's limits of |pitch| and |roll| [rad].
struct AttitudeLimits {
    double amber = 0.4363;  ///< 25°
    double red = 0.6109;    ///< 35°
    bool operator==(const AttitudeLimits&) const = default;
};

/// Distances from tipping over [rad] that give amber and red: 20° and 10°. Soft ground and braking
/// need this reserve.
inline constexpr double kAmberReserve = 0.3491, kRedReserve = 0.1745;

struct Attitude {
    AttitudeLevel pitch = AttitudeLevel::Level, roll = AttitudeLevel::Level;
    /// Angles at which it tips over on that side [rad], with the sign of the angle.
    double pitchTips = 0.0, rollTips = 0.0;
    /// Active limits of |pitch| and |roll| on that side [rad].
    AttitudeLimits pitchLimits{}, rollLimits{};
    bool beyondTipping = false;  ///< pitch or roll is beyond the angle at which the robot tips over
    AttitudeLevel worst() const { return pitch > roll ? pitch : roll; }
    bool operator==(const Attitude&) const = default;
};

/// Returns the levels of pitch and roll, and the active limits. Red begins at the smaller of
/// limits.red and tip-over − kRedReserve. Amber begins at the smaller of limits.amber and tip-over −
/// kAmberReserve. Amber and red raise an alarm and end feel forward. Beyond tip-over no exploration
/// begins; drive keys still act.
Attitude attitudeOf(const Measurement& line, const RobotModel& robot, const AttitudeLimits& limits);

}  // namespace terratact
