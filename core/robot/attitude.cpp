#include "core/robot/attitude.h"

#include <algorithm>
#include <cmath>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

// [m] a flipper's tip supports the robot if it lies at most this much higher than the tracks
constexpr double kAsLow = 0.005;

/// Returns a point on a flipper's axis, base frame.
Vec2 along(const FlipperGeometry& flipper, double angle, double distance)
{
    const Vec2 axis = flipperAxis(flipper, angle);
    return {flipper.pivot.x + distance * axis.x, flipper.pivot.z + distance * axis.z};
}

/// Returns the active limits on a side that tips over at this angle.
AttitudeLimits limitsInForce(double tips, const AttitudeLimits& limits)
{
    return {.amber = std::min(limits.amber, std::abs(tips) - kAmberReserve),
            .red = std::min(limits.red, std::abs(tips) - kRedReserve)};
}

AttitudeLevel levelOf(double angle, const AttitudeLimits& inForce)
{
    if (std::abs(angle) >= inForce.red) return AttitudeLevel::Red;
    return std::abs(angle) >= inForce.amber ? AttitudeLevel::Amber : AttitudeLevel::Level;
}

}  // namespace

TipOver tipOver(const RobotModel& robot, double front, double rear)
{
    const double total = robot.totalMass();
    Vec2 com{robot.bodyMass * robot.bodyCom.x / total, robot.bodyMass * robot.bodyCom.z / total};
    const double ground = robot.trackZ - robot.trackRadius;
    double foremost = robot.trackAxle / 2.0, rearmost = -foremost;
    const auto add = [&](const FlipperGeometry& flipper, double angle) {
        const Vec2 mass = along(flipper, angle, flipper.comDistance);
        com.x += flipper.mass * mass.x / total;
        com.z += flipper.mass * mass.z / total;
        const Vec2 tip = along(flipper, angle, flipper.axleDistance);
        if (tip.z - flipper.tipRadius > ground + kAsLow) return;
        foremost = std::max(foremost, tip.x);
        rearmost = std::min(rearmost, tip.x);
    };
    add(robot.front, front);
    add(robot.rear, rear);
    const double height = com.z - ground;
    const double aside = robot.bodyMass * robot.lateral.bodyComY / total;  // left positive
    return {.noseUp = std::atan2(com.x - rearmost, height),
            .noseDown = std::atan2(foremost - com.x, height),
            .leftUp = std::atan2(robot.halfWidth + aside, height),
            .rightUp = std::atan2(robot.halfWidth - aside, height)};
}

Attitude attitudeOf(const Measurement& line, const RobotModel& robot, const AttitudeLimits& limits)
{
    const Proprioception s = proprioception(line);
    const TipOver tips = tipOver(robot, s.front, s.rear);
    Attitude attitude;
    attitude.pitchTips = line.pitch >= 0.0 ? tips.noseUp : -tips.noseDown;
    attitude.rollTips = line.roll >= 0.0 ? tips.leftUp : -tips.rightUp;
    attitude.pitchLimits = limitsInForce(attitude.pitchTips, limits);
    attitude.rollLimits = limitsInForce(attitude.rollTips, limits);
    attitude.pitch = levelOf(line.pitch, attitude.pitchLimits);
    attitude.roll = levelOf(line.roll, attitude.rollLimits);
    attitude.beyondTipping = std::abs(line.pitch) > std::abs(attitude.pitchTips)
                          || std::abs(line.roll) > std::abs(attitude.rollTips);
    return attitude;
}

}  // namespace terratact
