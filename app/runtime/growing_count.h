#pragma once

#include <cstdint>
#include <optional>

namespace terratact {

/// Tracks a count of errors since the start, and whether it grew recently.
class GrowingCount {
public:
    static constexpr double kLately = 5.0;  ///< [s]

    /// Returns true if the count grew within the last kLately. now: any monotonic clock [s]. Call several times a
    /// second.
    bool grewLately(std::uint64_t count, double now)
    {
        if (count > count_) grew_ = now;
        count_ = count;
        return grew_ && now - *grew_ < kLately;
    }

private:
    std::uint64_t count_ = 0;
    std::optional<double> grew_;  ///< [s] time of the last growth
};

}  // namespace terratact
