#include "core/sim/robot_stance.h"

#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

constexpr double kAbovePress = 0.1;  // [rad] start of a press above the present angle

/// Returns the pose in the middle between both sides.
Pose middlePose(const TwoTrackPose& pose)
{
    const auto mean = [&pose](Flipper left, Flipper right) {
        return (pose.flippers[indexOf(left)] + pose.flippers[indexOf(right)]) / 2.0;
    };
    return {.base = pose.base,
            .pitch = pose.pitch,
            .front = mean(Flipper::FrontLeft, Flipper::FrontRight),
            .rear = mean(Flipper::RearLeft, Flipper::RearRight)};
}

}  // namespace

RobotStance::RobotStance(RobotModel robot, GroundLines ground, const GroundOptions& options)
    : robot_(std::move(robot)), ground_(std::move(ground)), options_(options),
      isOnePlane_(ground_.isOnePlane())
{
    if (!isOnePlane_) tracks_.emplace();
}

const RestPose& RobotStance::plane() const
{
    if (tracks_) throw std::logic_error("RobotStance: the robot stands on two tracks");
    return plane_;
}

bool RobotStance::settle(double x, const FlipperTargets& targets)
{
    return isOnePlane_ ? settlePlane(x, targets) : settleTracks(x, targets);
}

bool RobotStance::settlePlane(double x, const FlipperTargets& targets)
{
    const FlipperDrive front =
        targets.torque ? FlipperDrive{PressTorque{*targets.torque, pose_.front + kAbovePress}}
                       : FlipperDrive{HoldAngle{targets.front[indexOf(Side::Left)]}};
    auto rest = restPose(robot_, ground_.lines().front().profile, x, front, HoldAngle{targets.rear},
                         pose_.pitch, options_);
    if (!rest) return false;
    plane_ = *std::move(rest);
    pose_ = plane_.pose;
    return true;
}

bool RobotStance::settleTracks(double x, const FlipperTargets& targets)
{
    PerFlipper<FlipperDrive> drives;
    for (const Side side : {Side::Left, Side::Right}) {
        drives[indexOf(frontFlipper(side))] =
            targets.torque
                ? FlipperDrive{PressTorque{*targets.torque / 2.0, frontAngle(side) + kAbovePress}}
                : FlipperDrive{HoldAngle{targets.front[indexOf(side)]}};
        drives[indexOf(rearFlipper(side))] = HoldAngle{targets.rear};
    }
    auto rest =
        restPose(robot_, ground_, x, drives, {tracks_->pose.pitch, tracks_->pose.roll}, options_);
    if (!rest) return false;
    tracks_ = *std::move(rest);
    pose_ = middlePose(tracks_->pose);
    return true;
}

double RobotStance::frontAngle(Side side) const
{
    return tracks_ ? tracks_->pose.flippers[indexOf(frontFlipper(side))] : pose_.front;
}

double RobotStance::frontTorque(Side side) const
{
    return tracks_ ? tracks_->torques[indexOf(frontFlipper(side))] : plane_.frontTorque / 2.0;
}

Heights RobotStance::truth(ProbeSide side) const
{
    if (!tracks_) return binHeights(ground_.lines().front().profile, imuPosition(robot_, pose_));
    const Vec2 imu = imuPosition(robot_, tracks_->pose);
    const Heights left = sideHeights(ground_, robot_, Side::Left, imu);
    const Heights right = sideHeights(ground_, robot_, Side::Right, imu);
    if (side != ProbeSide::Middle) return side == ProbeSide::Left ? left : right;
    Heights mean{};
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (left[i] + right[i]) / 2.0;
    return mean;
}

}  // namespace terratact
