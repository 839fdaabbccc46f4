#include "core/strip/turn_watch.h"

#include <algorithm>

namespace terratact {

bool TurnWatch::add(double way, double heading)
{
    constexpr double kStretches = 30.0;
    while (!recent_.empty() && recent_.front().begin < way - way_) recent_.pop_front();
    if (recent_.empty() || way - recent_.back().begin >= way_ / kStretches)
        recent_.push_back({way, heading, heading});
    recent_.back().lowest = std::min(recent_.back().lowest, heading);
    recent_.back().highest = std::max(recent_.back().highest, heading);
    const auto lowest = std::ranges::min(recent_, {}, &Stretch::lowest).lowest;
    const auto highest = std::ranges::max(recent_, {}, &Stretch::highest).highest;
    if (highest - lowest <= turn_) return false;
    recent_.clear();
    return true;
}

}  // namespace terratact
