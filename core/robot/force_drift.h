#pragma once

#include <array>
#include <deque>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Returns true if nothing should press on the front flippers. The robot halts or drives, and both
/// flippers are raised by at least 0.3 rad. Every element feels less than `limit` [N].
bool isUnloaded(const Measurement& measurement, double limit);

/// Drift of the biases of one array since calibration: the median of each element over the last 10
/// s without load. It keeps its value while there is load. It has no clock and bounded memory.
class ForceDrift {
public:
    static constexpr double kSpacing = 0.1;   ///< [s] a reading that follows sooner is ignored
    static constexpr std::size_t kMax = 100;  ///< readings: 10 s
    static constexpr std::size_t kMin = 20;   ///< fewer readings give no drift
    static constexpr double kNotable = 0.3;   ///< [N] drift that the operator should know about

    /// [N] signed, beyond the bias.
    using Forces = std::array<std::optional<double>, kForceElements>;

    /// Adds a reading without load. `time` [s] may come from any clock; a clock that jumps back
    /// starts a new window. An element without a finite value is skipped. Throws
    /// std::invalid_argument unless the time is finite.
    void add(double time, const Forces& forces);

    /// Returns the drift [N] of element 0 … 5; empty until there are kMin readings. Throws
    /// std::out_of_range.
    std::optional<double> drift(int element) const;

private:
    std::array<std::deque<double>, kForceElements> readings_;
    std::optional<double> taken_;
};

}  // namespace terratact
