#include "core/robot/two_tracks.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace terratact {
namespace {

template <class T>
void exchangeSides(PerFlipper<T>& values)
{
    std::swap(values[indexOf(Flipper::FrontLeft)], values[indexOf(Flipper::FrontRight)]);
    std::swap(values[indexOf(Flipper::RearLeft)], values[indexOf(Flipper::RearRight)]);
}

}  // namespace

double sideLift(const RobotModel& robot, double y, double roll)
{
    const double height = robot.trackRadius - robot.trackZ;
    return y * std::sin(roll) + height * (1.0 - std::cos(roll));
}

Pose sidePose(const RobotModel& robot, const TwoTrackPose& pose, Side side, double y)
{
    const double lift = sideLift(robot, signOf(side) * y, pose.roll);
    return {.base = {pose.base.x - lift * std::sin(pose.pitch),
                     pose.base.z + lift * std::cos(pose.pitch)},
            .pitch = pose.pitch + signOf(side) * pose.differential,
            .front = pose.flippers[indexOf(frontFlipper(side))],
            .rear = pose.flippers[indexOf(rearFlipper(side))]};
}

Vec2 imuPosition(const RobotModel& robot, const TwoTrackPose& pose)
{
    const Vec2 r = rotated({robot.imu.x, robot.imu.z * std::cos(pose.roll)}, pose.pitch);
    return {pose.base.x + r.x, pose.base.z + r.z};
}

TwoTrackPose mirrored(const TwoTrackPose& pose)
{
    TwoTrackPose mirror = pose;
    mirror.roll = -pose.roll;
    mirror.differential = -pose.differential;
    exchangeSides(mirror.flippers);
    return mirror;
}

TwoTrackReadings twoTrackReadings(const Measurement& m)
{
    TwoTrackReadings s;
    s.pitch = m.pitch;
    s.roll = m.roll;
    s.flippers = {m.frontLeft, m.frontRight, m.rearLeft, m.rearRight};
    s.differential = m.differential;
    s.currents = motorCurrents(m);
    s.forces = {m.sides.left, m.sides.right, m.rearSides.left, m.rearSides.right};
    return s;
}

Measurement measurementOf(const TwoTrackReadings& s)
{
    Measurement m;
    m.pitch = s.pitch;
    m.roll = s.roll;
    std::tie(m.frontLeft, m.frontRight, m.rearLeft, m.rearRight) = std::tuple_cat(s.flippers);
    setCurrents(m, s.currents);
    const auto forces = [&s](Flipper left, Flipper right) {
        return SideForces{s.forces[indexOf(left)], s.forces[indexOf(right)]};
    };
    setSides(m, forces(Flipper::FrontLeft, Flipper::FrontRight));
    m.rearSides = forces(Flipper::RearLeft, Flipper::RearRight);
    m.differential = s.differential;
    return m;
}

TwoTrackReadings mirrored(const TwoTrackReadings& readings)
{
    TwoTrackReadings mirror = readings;
    mirror.roll = -readings.roll;
    if (mirror.differential) mirror.differential = -*mirror.differential;
    exchangeSides(mirror.flippers);
    exchangeSides(mirror.currents);
    exchangeSides(mirror.forces);
    return mirror;
}

}  // namespace terratact
