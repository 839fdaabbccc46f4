#include "core/robot/side_plane.h"

#include <cmath>
#include <numbers>

namespace terratact {

namespace {

// Noise as in core/sim/sensor_noise.h.
constexpr double kRollSd = 0.0087, kFlipperSd = 0.0017;        // [rad]
constexpr double kMotorSd = 0.05;                              // [A]
constexpr double kElementShareSd = 0.10, kElementFloor = 0.3;  // share, [N]

using Reading = std::optional<double>;

/// Returns true if the readings differ by at most kSymmetricSd standard deviations of their
/// difference. sd: of one reading.
bool agree(double left, double right, double sd)
{
    return std::abs(left - right) <= kSymmetricSd * std::numbers::sqrt2 * sd;
}

/// Returns true if these readings agree, or one of them is not measured.
bool agree(const Reading& left, const Reading& right, double sd)
{
    return !left || !right || agree(*left, *right, sd);
}

bool forcesAgree(const TwoTrackReadings& s)
{
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e) {
        const Reading& left = s.forces[indexOf(Flipper::FrontLeft)][e];
        const Reading& right = s.forces[indexOf(Flipper::FrontRight)][e];
        const double mean = meanOfSides(left, right).value_or(0.0);
        if (!agree(left, right, std::hypot(kElementShareSd * mean, kElementFloor))) return false;
    }
    return true;
}

}  // namespace

RobotModel inSidePlane(const RobotModel& robot, double roll, double y)
{
    RobotModel side = robot;
    side.imu.z = robot.imu.z * std::cos(roll) - sideLift(robot, y, roll);
    return side;
}

Proprioception sideReadings(const TwoTrackReadings& s, Side side)
{
    const std::size_t front = indexOf(frontFlipper(side)), rear = indexOf(rearFlipper(side));
    return {.pitch = s.pitch,
            .front = s.flippers[front],
            .rear = s.flippers[rear],
            .frontCurrent = s.currents[front],
            .rearCurrent = s.currents[rear],
            .force = s.forces[front]};
}

Proprioception planeReadings(const TwoTrackReadings& s)
{
    return proprioception(measurementOf(s));
}

bool sidesDiffer(const TwoTrackReadings& s)
{
    const Proprioception left = sideReadings(s, Side::Left), right = sideReadings(s, Side::Right);
    const bool alike = std::abs(s.roll) <= kSymmetricSd * kRollSd
                    && std::abs(s.differential.value_or(0.0)) <= kSymmetricSd * kFlipperSd
                    && agree(left.front, right.front, kFlipperSd)
                    && agree(left.rear, right.rear, kFlipperSd)
                    && agree(left.frontCurrent, right.frontCurrent, kMotorSd)
                    && agree(left.rearCurrent, right.rearCurrent, kMotorSd) && forcesAgree(s);
    return !alike;
}

bool isSymmetric(const TwoTrackReadings& s)
{
    const auto missing = [&s](Side side) { return missingFeatures(sideReadings(s, side)); };
    return !sidesDiffer(s) && missing(Side::Left) == missing(Side::Right);
}

bool hasTurned(const std::optional<double>& differential)
{
    return std::abs(differential.value_or(0.0)) > kTurnedDifferential;
}

}  // namespace terratact
