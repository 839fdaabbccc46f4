#include "widgets/signals/peak_hold.h"

#include <cstddef>

namespace terratact {

void PeakHold::add(double time, double value)
{
    if (!falling_.empty() && time < falling_.back().first) falling_.clear();
    while (!falling_.empty() && falling_.back().second <= value) falling_.pop_back();
    falling_.emplace_back(time, value);
    constexpr std::size_t kMax = 512;  // bound for a fast source: only the largest values stay
    if (falling_.size() > kMax) falling_.pop_back();
    forget(time);
}

void PeakHold::forget(double time)
{
    while (!falling_.empty() && time - falling_.front().first > kHold) falling_.pop_front();
}

std::optional<double> PeakHold::peak() const
{
    return falling_.empty() ? std::nullopt : std::optional(falling_.front().second);
}

}  // namespace terratact
