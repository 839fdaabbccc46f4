#include "core/atem/advance_watch.h"

#include <cmath>
#include <stdexcept>

namespace terratact {

AdvanceWatch::AdvanceWatch(const Measurement& before, double distance)
    : known_(before.travelled.has_value()), begin_(before.travelled.value_or(0.0)),
      distance_(distance)
{
    if (!(distance > 0.0)) throw std::invalid_argument("an advance must be longer than 0 m");
}

AdvanceWatch::Result AdvanceWatch::poll(const Measurement& m)
{
    if (!known_ || !m.travelled || !std::isfinite(*m.travelled)) return Result::NoOdometry;
    way_ = *m.travelled - begin_;
    if (std::abs(way_) > distance_ + kOverrun) return Result::RanOn;
    driven_ = driven_ || m.activity == RobotActivity::Driving || std::abs(way_) > kStarts;
    const bool stands = m.activity == RobotActivity::Halted || m.activity == RobotActivity::Pressed;
    if (!driven_ || !stands) return Result::Running;
    return way_ >= kMinShare * distance_ ? Result::Advanced : Result::NotMoved;
}

}  // namespace terratact
