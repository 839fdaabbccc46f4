#pragma once

#include <optional>

namespace terratact {

/// Watchdog of the operator's window: detects that polls every few milliseconds have paused. It has
/// no clock: `now` is any monotonic clock [s].
class StallWatch {
public:
    static constexpr double kStall = 0.1;  ///< [s] longest pause of a window that is not frozen

    /// Records a poll. Returns the pause before it [s] if it was longer than kStall.
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
