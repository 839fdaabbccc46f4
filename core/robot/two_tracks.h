#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/robot/kinematics.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Order of the four flippers in arrays.
enum class Flipper : std::uint8_t { FrontLeft, FrontRight, RearLeft, RearRight };
inline constexpr std::size_t kFlippers = 4;
template <class T>
using PerFlipper = std::array<T, kFlippers>;

constexpr std::size_t indexOf(Flipper flipper)
{
    return static_cast<std::size_t>(flipper);
}
constexpr Flipper frontFlipper(Side side)
{
    return side == Side::Left ? Flipper::FrontLeft : Flipper::FrontRight;
}
constexpr Flipper rearFlipper(Side side)
{
    return side == Side::Left ? Flipper::RearLeft : Flipper::RearRight;
}
constexpr Side opposite(Side side)
{
    return side == Side::Left ? Side::Right : Side::Left;
}
/// Returns +1 for left and −1 for right: the sign of y.
constexpr double signOf(Side side)
{
    return side == Side::Left ? 1.0 : -1.0;
}

/// Pose of a robot with two tracks. The body's frame is rolled about its x axis. Then it is pitched
/// about the y axis of the frame along gravity.
struct TwoTrackPose {
    Vec2 base;                      ///< base origin, frame along gravity [m]
    double pitch = 0.0;             ///< [rad] nose up positive
    double roll = 0.0;              ///< [rad] left side up positive
    PerFlipper<double> flippers{};  ///< [rad] tip up positive
    double differential = 0.0;      ///< [rad] left track nose up against the body
    bool operator==(const TwoTrackPose&) const = default;
};

/// Returns the pose of a vertical plane along the robot at y on one side [m from the middle, ≥ 0].
/// In this plane the side's track and flippers move like the plane's robot:
///   base + (y sin φ + h (1 − cos φ)) up,   up = (−sin θ, cos θ)
/// θ: pitch, φ: roll, h: height of the base above the tracks' lower edge. The lower edge lies where
/// that of the rolled rigid robot lies. Other points keep their distance from it, and y does not
/// shrink with cos φ. The pitch is that of the side's track; see TrackDifferential.
Pose sidePose(const RobotModel& robot, const TwoTrackPose& pose, Side side, double y);

/// Returns the lift of that plane against the base [m]: y sin φ + h (1 − cos φ). y: signed.
double sideLift(const RobotModel& robot, double y, double roll);

/// Returns the IMU in the pose's frame, x and z: the origin of the DEM frame.
Vec2 imuPosition(const RobotModel& robot, const TwoTrackPose& pose);

/// Returns the pose with left and right exchanged.
TwoTrackPose mirrored(const TwoTrackPose& pose);

/// Readings of the proprioceptive sensors of both sides. An empty optional means "not measured".
struct TwoTrackReadings {
    double pitch = 0.0, roll = 0.0;                ///< [rad] as in TwoTrackPose
    PerFlipper<double> flippers{};                 ///< [rad]
    std::optional<double> differential;            ///< [rad] empty: locked
    PerFlipper<std::optional<double>> currents{};  ///< [A] per motor, positive = pressing down
    /// [N] element 1 (pivot) … 6 (tip) of each flipper
    PerFlipper<std::array<std::optional<double>, kForceElements>> forces{};
    bool operator==(const TwoTrackReadings&) const = default;
};

/// Returns the readings of both sides of a line of telemetry. A force of which only the mean of both
/// sides is known stays empty. proprioception() averages the sides.
TwoTrackReadings twoTrackReadings(const Measurement& measurement);

/// Returns a line of telemetry with these readings, as twoTrackReadings() reads it. Other values
/// are those of a new Measurement.
Measurement measurementOf(const TwoTrackReadings& readings);

/// Returns the readings with left and right exchanged.
TwoTrackReadings mirrored(const TwoTrackReadings& readings);

}  // namespace terratact
