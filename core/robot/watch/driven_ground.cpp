#include "core/robot/watch/driven_ground.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kNewestPitch = 0.5;    // share of the newest line in the pitch
constexpr double kNewestCurrent = 0.2;  // share of the newest line in the current

long cellOf(double x)
{
    return std::lround(x / DrivenGround::kCell);
}

/// Returns the length of the tracks to both sides of the base origin [m].
double trackReach(const RobotModel& r)
{
    return r.trackAxle / 2.0 + r.trackRadius;
}

}  // namespace

double centreOfMass(const RobotModel& r)
{
    return (r.bodyMass * r.bodyCom.x + r.front.mass * r.front.pivot.x
            + r.rear.mass * r.rear.pivot.x)
         / r.totalMass();
}

void RearLoad::add(const Measurement& line)
{
    if (const auto now = proprioception(line).rearCurrent)
        current_ += kNewestCurrent * (*now - current_);
}

double supportAngle(const RobotModel& robot, double rear)
{
    const FlipperGeometry& f = robot.rear;
    const Vec2 axis = flipperAxis(f, rear);
    const double tipX = f.pivot.x + f.axleDistance * axis.x;
    const double below =
        robot.trackZ - robot.trackRadius - (f.pivot.z + f.axleDistance * axis.z - f.tipRadius);
    return below > 0.0 ? std::atan2(below, robot.trackAxle / 2.0 - tipX) : 0.0;
}

DrivenGround::DrivenGround(const RobotModel& robot) : robot_(robot), turnsAt_(centreOfMass(robot))
{
}

Pose DrivenGround::poseWith(double pitch, double front) const
{
    const Vec2 below = rotated({turnsAt_, robot_.trackZ - robot_.trackRadius}, pitch);
    return {.base = {point_.x - below.x, point_.z - below.z},
            .pitch = pitch,
            .front = front,
            .rear = pose_.rear};
}

void DrivenGround::add(const Measurement& line, bool isRearLoaded)
{
    moved_ = false;
    if (!line.travelled) return;
    const double before = travelled_ ? pitch_ : line.pitch;
    pitch_ = before + (travelled_ ? kNewestPitch * (line.pitch - before) : 0.0);
    pose_.rear = (line.rearLeft + line.rearRight) / 2.0;
    const double ds = travelled_ ? *line.travelled - *travelled_ : 0.0;
    const double support = isRearLoaded ? supportAngle(robot_, pose_.rear) : 0.0;
    const double way = ds / std::cos(support);
    const Vec2 along = rotated({1.0, 0.0}, (before + pitch_) / 2.0 + support);
    point_ = {point_.x + way * along.x, point_.z + way * along.z};
    way_ += std::abs(ds);
    pose_ = poseWith(pitch_, (line.frontLeft + line.frontRight) / 2.0);
    if (!travelled_) passedFrom_ = pose_.base.x + trackReach(robot_);
    travelled_ = line.travelled;
    moved_ = line.activity == RobotActivity::Driving && ds > 0.0;
    if (moved_) lower();
}

void DrivenGround::lower()
{
    const TaperedHull track = shapeAt(robot_, pose_).track;
    const double reach = trackReach(robot_);
    for (long cell = cellOf(pose_.base.x - reach); cell <= cellOf(pose_.base.x + reach); ++cell) {
        const double edge = lowerBoundary(track, static_cast<double>(cell) * kCell);
        if (!std::isfinite(edge)) continue;
        const auto [known, isNew] = highest_.emplace(cell, edge);
        if (!isNew) known->second = std::min(known->second, edge);
    }
    highest_.erase(highest_.begin(), highest_.lower_bound(cellOf(pose_.base.x - kKept)));
    highest_.erase(highest_.upper_bound(cellOf(pose_.base.x + kKept)), highest_.end());
}

std::optional<double> DrivenGround::highestAt(double x) const
{
    const auto found = highest_.find(cellOf(x));
    return found == highest_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace terratact
