#include "core/wire/logs/log_clock.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

/// Returns a difference of two times [s]. If they are since 1970, it is rounded to microseconds: a
/// double holds no more digits of them.
double withoutNoise(double difference, double time)
{
    constexpr double kSince1970 = 1e8, kPerSecond = 1e6;
    return std::abs(time) < kSince1970 ? difference
                                       : std::round(difference * kPerSecond) / kPerSecond;
}

}  // namespace

std::optional<double> LogClock::add(double time, const std::string& interface)
{
    ++frames_;
    if (!first_) {
        first_ = base_ = last_ = time;
        lastOf_[interface] = time;
        return std::nullopt;
    }
    const auto known = lastOf_.find(interface);
    const double back = last_ - time;
    const bool isSet = std::abs(back) > kMaxJumpForward || back > kDisorder
                    || (known != lastOf_.end() && known->second - time > kJitter);
    if (time <= last_) ++notLater_;
    std::optional<double> step;
    if (isSet) {
        step = back > kDisorder || back < 0.0 ? back : known->second - time;
        base_ = time - elapsed_;
        lastOf_.clear();
    }
    elapsed_ = std::max(elapsed_, withoutNoise(time - base_, time));
    last_ = isSet ? time : std::max(last_, time);
    if (lastOf_.size() < kMaxInterfaces || lastOf_.contains(interface)) lastOf_[interface] = time;
    return step;
}

}  // namespace terratact
