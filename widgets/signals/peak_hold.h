#pragma once

#include <deque>
#include <optional>
#include <utility>

namespace terratact {

/// Maximum over the last kHold seconds.
class PeakHold {
public:
    static constexpr double kHold = 3.0;  ///< [s]

    /// `time` [s] must not be NaN. A time before the last one restarts the maximum.
    void add(double time, double value);
    void forget(double time);  ///< drops values older than kHold
    std::optional<double> peak() const;

private:
    std::deque<std::pair<double, double>>
        falling_;  // (time, value); each value exceeds all later ones
};

}  // namespace terratact
