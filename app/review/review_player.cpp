#include "app/review/review_player.h"

#include <algorithm>
#include <cmath>

namespace terratact {

void ReviewPlayer::setRange(double begin, double end)
{
    begin_ = begin;
    end_ = std::max(begin, end);
    position_ = std::clamp(position_, begin_, end_);
}

void ReviewPlayer::seek(double seconds)
{
    if (std::isfinite(seconds)) position_ = std::clamp(seconds, begin_, end_);
}

void ReviewPlayer::play(bool backwards)
{
    playing_ = true;
    backwards_ = backwards;
    if (backwards && position_ <= begin_) position_ = end_;
    if (!backwards && position_ >= end_ && !following_) position_ = begin_;
}

void ReviewPlayer::setSpeed(double speed)
{
    if (std::isfinite(speed)) speed_ = std::clamp(speed, kSlowest, kFastest);
}

void ReviewPlayer::advance(double elapsed)
{
    if (!playing_ || !(elapsed > 0.0)) return;
    const double way = std::min(elapsed, kMaxStepTime) * speed_;
    double next = position_ + (backwards_ ? -way : way);
    if (loops()) {
        const double from = std::min(*a_, *b_), to = std::max(*a_, *b_);
        if (!backwards_ && (next > to || next < from)) next = from;
        if (backwards_ && (next < from || next > to)) next = to;
    }
    position_ = std::clamp(next, begin_, end_);
    const bool atEnd = backwards_ ? position_ <= begin_ : position_ >= end_;
    if (atEnd && !loops() && !(following_ && !backwards_)) playing_ = false;
}

}  // namespace terratact
