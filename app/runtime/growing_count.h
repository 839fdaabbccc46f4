#pragma once

#include <cstdint>
#include <optional>

namespace terratact {

/// A count, since the start, of what should not happen, and whether it has just grown.
class GrowingCount {
public:
    static constexpr double kLately = 5.0;  ///< [s]

    /// Within the last kLately.  now: [s] on any monotonic clock; to be called several times a second.
    bool grewLately(std::uint64_t count, double now)
    {
        if (count > count_) grew_ = now;
        count_ = count;
        return grew_ && now - *grew_ < kLately;
    }

private:
    std::uint64_t count_ = 0;
    std::optional<double> grew_;  ///< [s] when
};

}  // namespace terratact
