#include "core/atem/pose_watch.h"

#include <cmath>

namespace terratact {

void PoseWatch::look(const Measurement& newest, std::uint64_t count)
{
    if (moved_) return;
    if (!differs(newest))
        suspectedAt_ = 0;
    else if (suspectedAt_ == 0)
        suspectedAt_ = count;
    else
        moved_ = count > suspectedAt_;
}

bool PoseWatch::differs(const Measurement& newest) const
{
    const auto beyond = [&](double Measurement::*value, double limit) {
        return std::abs(turnBetween(scene_.*value, newest.*value)) > limit;
    };
    return newest.activity == RobotActivity::Driving || beyond(&Measurement::pitch, kTilt)
        || beyond(&Measurement::roll, kTilt) || beyond(&Measurement::frontLeft, kFlipper)
        || beyond(&Measurement::frontRight, kFlipper) || beyond(&Measurement::rearLeft, kFlipper)
        || beyond(&Measurement::rearRight, kFlipper) || tracksMoved(newest);
}

/// By its tracks, where both lines tell.
bool PoseWatch::tracksMoved(const Measurement& newest) const
{
    if (newest.travelled && scene_.travelled
        && std::abs(*newest.travelled - *scene_.travelled) > kTravelled)
        return true;
    return newest.turned && scene_.turned
        && std::abs(turnBetween(*scene_.turned, *newest.turned)) > kTurned;
}

}  // namespace terratact
