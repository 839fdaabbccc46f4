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
    const Proprioception s = proprioception(newest);
    return newest.activity == RobotActivity::Driving
        || std::abs(s.pitch - scene_.pitch) > kPitchChange
        || std::abs(s.front - scene_.front) > kFlipperChange
        || std::abs(s.rear - scene_.rear) > kFlipperChange;
}

}  // namespace terratact
