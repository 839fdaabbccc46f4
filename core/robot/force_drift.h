#pragma once

#include <array>
#include <deque>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Nothing should press on the front flippers: the robot halts or drives, both are raised by at least
/// 0.3 rad, and every element feels less than `limit` [N].
bool isUnloaded(const Measurement& measurement, double limit);

/// How far the biases of one array are from those in its calibration: the median, per element, of what it
/// felt during the last 10 s without load.  It stands while there is load; no clock, bounded memory.
class ForceDrift {
public:
    static constexpr double kSpacing = 0.1;   ///< [s] readings that come sooner are left out
    static constexpr std::size_t kMax = 100;  ///< readings: 10 s
    static constexpr std::size_t kMin = 20;   ///< fewer say nothing
    static constexpr double kNotable = 0.3;   ///< [N] the operator should hear of

    using Forces =
        std::array<std::optional<double>, kForceElements>;  ///< [N] signed, beyond the bias

    /// A reading without load; `time` [s] on any one clock, and a clock that jumps back begins anew.
    /// An element that has no finite value is passed over.  Throws std::invalid_argument unless the
    /// time is finite.
    void take(double time, const Forces& forces);

    /// [N] of element 0 … 5; empty as long as too little was read.  Throws std::out_of_range.
    std::optional<double> drift(int element) const;

private:
    std::array<std::deque<double>, kForceElements> readings_;
    std::optional<double> taken_;
};

}  // namespace terratact
