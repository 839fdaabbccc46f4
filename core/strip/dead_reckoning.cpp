#include "core/strip/dead_reckoning.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

void requireFiniteLine(const OdometryLine& line)
{
    for (const double value : {line.travelled, line.pitch, line.roll, line.turned})
        if (!std::isfinite(value))
            throw std::invalid_argument("Odometry: way, pitch, roll and heading must be finite");
}

}  // namespace

double carriedSd(const ImuMotion& motion, std::span<const double> slopes)
{
    double worst = slopes.empty() ? std::abs(motion.slipUp) : 0.0;
    for (const double slope : slopes)
        worst = std::max(worst, std::abs(slope * motion.slipForward - motion.slipUp));
    return std::hypot(worst, motion.upSd);
}

OdometryLine odometryOf(const Measurement& line)
{
    if (!line.travelled) throw std::invalid_argument("odometryOf: the line has no odometry");
    return {*line.travelled, line.pitch, line.roll, line.turned.value_or(0.0)};
}

Odometry::Odometry(const RobotModel& robot, const OdometryLine& start)
    : share_(robot.travelledSdShare), pitchSd_(robot.pitchSd),
      pivotSd_(robot.trackAxle / std::sqrt(12.0)),
      rollPivotSd_(robot.lateral.trackY / std::sqrt(3.0)), imu_{robot.imu.x,
                                                                robot.imu.z + robot.baseHeight}
{
    requireFiniteLine(start);
    now_.line = start;
    now_.imu = imuAt({}, start.pitch);
}

Vec2 Odometry::imuAt(const Vec2& rolled, double pitch) const
{
    const Vec2 lever = rotated(imu_, pitch);
    return {rolled.x + lever.x, rolled.z + lever.z};
}

/// Returns true if a step may be the flicker of a standing robot's way.
bool Odometry::isFlicker(double step) const
{
    constexpr double kRounding = 1e-9;  // [m]
    return step * now_.direction < 0.0 && std::abs(step) <= kFlicker + kRounding;
}

ReckonedState Odometry::after(const OdometryLine& line) const
{
    requireFiniteLine(line);
    ReckonedState next = now_;
    next.line = line;
    if (isFlicker(line.travelled - now_.line.travelled)) next.line.travelled = now_.line.travelled;
    const double ds = next.line.travelled - now_.line.travelled;
    if (ds != 0.0) next.direction = std::copysign(1.0, ds);
    const Vec2 along = rotated({1.0, 0.0}, (line.pitch + now_.line.pitch) / 2.0);
    next.rolled = {now_.rolled.x + ds * along.x, now_.rolled.z + ds * along.z};
    next.way += std::abs(ds);
    next.wayAlong = {now_.wayAlong.x + std::abs(ds) * along.x,
                     now_.wayAlong.z + std::abs(ds) * along.z};
    next.heading += turnBetween(now_.line.turned, line.turned);
    const double course = (now_.heading + next.heading) / 2.0;
    next.planX += ds * along.x * std::cos(course);
    next.planY += ds * along.x * std::sin(course);
    next.imu = imuAt(next.rolled, line.pitch);
    return next;
}

ImuMotion Odometry::motion(const ReckonedState& from, const ReckonedState& to,
                           const TiltRange& tilt) const
{
    const double way = std::max(0.0, to.way - from.way);  // a scene may be newer by a line
    return {.forward = to.imu.x - from.imu.x,
            .up = to.imu.z - from.imu.z,
            .way = way,
            .slipForward = share_ * (to.wayAlong.x - from.wayAlong.x),
            .slipUp = share_ * (to.wayAlong.z - from.wayAlong.z),
            .upSd = std::hypot(pitchSd_ * way, pivotSd_ * tilt.pitch, rollPivotSd_ * tilt.roll)};
}

DeadReckoning::DeadReckoning(const RobotModel& robot, double travelled, double pitch)
    : odometry_(robot, {travelled, pitch}), start_(odometry_.now())
{
}

void DeadReckoning::add(double travelled, double pitch)
{
    odometry_.add({travelled, pitch});
    largestChange_ = std::max(largestChange_, std::abs(pitchChange()));
}

}  // namespace terratact
