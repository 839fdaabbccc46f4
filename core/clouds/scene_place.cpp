#include "core/clouds/scene_place.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kMinHalfStrip = 0.02;  // [m]

double partY(const RobotModel& robot, TruthLine line)
{
    return isUnderFlippers(line) ? robot.lateral.flipperY : robot.lateral.trackY;
}

/// Returns the pose of a line's plane with the IMU at the origin.
Pose linePose(const RobotModel& robot, const TwoTrackReadings& s, TruthLine line)
{
    TwoTrackPose pose{.base = {},
                      .pitch = s.pitch,
                      .roll = s.roll,
                      .flippers = s.flippers,
                      .differential = s.differential.value_or(0.0)};
    const Vec2 imu = imuPosition(robot, pose);
    pose.base = {-imu.x, -imu.z};
    return sidePose(robot, pose, sideOf(line), partY(robot, line));
}

}  // namespace

Eigen::Vector3d ScenePlace::toDem(const Eigen::Vector3d& point) const
{
    const Eigen::Vector3d d = point - imu;
    const double cosine = std::cos(heading), sine = std::sin(heading);
    return {cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x(), d.z()};
}

Eigen::Vector3d ScenePlace::toCloud(const Eigen::Vector3d& dem) const
{
    const double cosine = std::cos(heading), sine = std::sin(heading);
    return imu
         + Eigen::Vector3d(cosine * dem.x() - sine * dem.y(), sine * dem.x() + cosine * dem.y(),
                           dem.z());
}

ScenePlace placeOf(const RobotModel& robot, std::size_t row, const TwoTrackReadings& s,
                   const CloudPose& base)
{
    const Eigen::Matrix3d axes = base.turn.toRotationMatrix();
    return {.row = row,
            .s = s,
            .imu = base.toOther({robot.imu.x, 0.0, robot.imu.z}),
            .heading = std::atan2(axes(1, 0), axes(0, 0)),
            .posePitch = std::asin(std::clamp(axes(2, 0), -1.0, 1.0)),
            .poseRoll = std::atan2(axes(2, 1), axes(2, 2))};
}

double lineY(const RobotModel& robot, TruthLine line, double roll)
{
    const double height = robot.imu.z - robot.trackZ + robot.trackRadius;
    return signOf(sideOf(line)) * partY(robot, line) * std::cos(roll) + height * std::sin(roll);
}

double lineHalfWidth(const RobotModel& robot, TruthLine line)
{
    const LateralGeometry& l = robot.lateral;
    return std::max(kMinHalfStrip, 0.5 * (isUnderFlippers(line) ? l.flipperWidth : l.trackWidth));
}

double partAbove(const RobotModel& robot, const TwoTrackReadings& s, TruthLine line, double x)
{
    const Pose pose = linePose(robot, s, line);
    if (!isUnderFlippers(line)) return lowerBoundary(trackAt(robot, pose), x);
    return std::min(lowerBoundary(flipperAt(robot.front, pose.front, pose), x),
                    lowerBoundary(flipperAt(robot.rear, pose.rear, pose), x));
}

double massX(const RobotModel& robot, const TwoTrackReadings& s)
{
    const Vec2 body =
        rotated({robot.bodyCom.x - robot.imu.x, robot.bodyCom.z - robot.imu.z}, s.pitch);
    return body.x;
}

}  // namespace terratact
