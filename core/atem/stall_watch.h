#pragma once

#include <optional>

namespace terratact {

/// Notices that whoever should look every few milliseconds did not.  No clock: `now` is any monotonic clock [s].
class StallWatch {
public:
    static constexpr double kStall = 0.1;  ///< [s] the operator's window counts as frozen beyond

    /// Told at every look; how long [s] it was frozen before this one, where that is more than kStall.
    std::optional<double> poll(double now)
    {
        const std::optional<double> before = last_;
        last_ = now;
        if (!before || !(now - *before > kStall)) return std::nullopt;
        return now - *before;
    }

private:
    std::optional<double> last_;
};

}  // namespace terratact
