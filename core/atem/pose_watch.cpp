#include "core/atem/pose_watch.h"

#include <cmath>

namespace terratact {

namespace {

/// Confirms a change of the pose: two successive lines of different count must show it. `since`
/// keeps the count of the first one; 0: none.
bool confirmed(bool isChanged, std::uint64_t count, std::uint64_t& since)
{
    if (!isChanged)
        since = 0;
    else if (since == 0)
        since = count;
    else
        return count > since;
    return false;
}

}  // namespace

void PoseWatch::poll(const Measurement& newest, std::uint64_t count)
{
    moved_ = moved_ || confirmed(differs(newest), count, suspectedAt_);
    left_ = left_ || confirmed(bodyMoved(newest), count, suspectedLeftAt_);
}

bool PoseWatch::tilted(const Measurement& newest) const
{
    return std::abs(turnBetween(scene_.pitch, newest.pitch)) > kTilt
        || std::abs(turnBetween(scene_.roll, newest.roll)) > kTilt;
}

bool PoseWatch::bodyMoved(const Measurement& newest) const
{
    const bool hasOdometry = newest.travelled && scene_.travelled && newest.turned && scene_.turned;
    return tilted(newest) || tracksMoved(newest)
        || (newest.activity == RobotActivity::Driving && !hasOdometry);
}

bool PoseWatch::differs(const Measurement& newest) const
{
    const auto beyond = [&](double Measurement::*value) {
        return std::abs(turnBetween(scene_.*value, newest.*value)) > kFlipper;
    };
    return newest.activity == RobotActivity::Driving || tilted(newest)
        || beyond(&Measurement::frontLeft) || beyond(&Measurement::frontRight)
        || beyond(&Measurement::rearLeft) || beyond(&Measurement::rearRight) || tracksMoved(newest);
}

/// Returns true if odometry differs, where both lines have it.
bool PoseWatch::tracksMoved(const Measurement& newest) const
{
    if (newest.travelled && scene_.travelled
        && std::abs(*newest.travelled - *scene_.travelled) > kTravelled)
        return true;
    return newest.turned && scene_.turned
        && std::abs(turnBetween(*scene_.turned, *newest.turned)) > kTurned;
}

}  // namespace terratact
