#include "app/shell/event_watch.h"

#include <algorithm>
#include <utility>

namespace terratact {

bool EventWatch::begins(int level)
{
    if (level <= timed_) return false;
    outer_.push_back(std::exchange(timed_, level));
    deepest_ = level;
    return true;
}

bool EventWatch::ends(int level, double seconds)
{
    timed_ = outer_.back();
    outer_.pop_back();
    if (deepest_ > level) return false;
    return longest_.size() < kKept || seconds > longest_.back().seconds;
}

void EventWatch::keep(LongEvent event)
{
    const auto place = std::upper_bound(
        longest_.begin(), longest_.end(), event,
        [](const LongEvent& a, const LongEvent& b) { return a.seconds > b.seconds; });
    longest_.insert(place, std::move(event));
    if (longest_.size() > kKept) longest_.pop_back();
}

}  // namespace terratact
