#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace terratact {

/// Continuous clock from the times of a log. They jump where the recording machine's clock was set:
/// back, or forward by more than kMaxJumpForward. A machine without a battery clock starts in 1970.
/// Frames of different interfaces may come up to kDisorder out of order, frames of one interface up
/// to kJitter.
class LogClock {
public:
    static constexpr double kMaxJumpForward = 3660.0 * 86'400.0;  ///< [s]
    static constexpr double kDisorder = 0.1, kJitter = 1e-3;      ///< [s]
    static constexpr std::size_t kMaxInterfaces = 64;  ///< interfaces whose order is watched

    /// Adds the next frame's time [s]. Returns the jump, if there is one: how far it lies before
    /// the last time, negative for a jump forward.
    std::optional<double> add(double time, const std::string& interface);

    /// Returns the time since the first frame [s], which never decreases. It continues after a jump
    /// from where it was. Times since 1970 give whole microseconds.
    double elapsed() const { return elapsed_; }

    std::size_t frames() const { return frames_; }
    std::size_t notLater() const { return notLater_; }  ///< frames whose time did not increase
    std::optional<double> first() const { return first_; }

private:
    std::optional<double> first_;
    double base_ = 0.0, elapsed_ = 0.0, last_ = 0.0;
    std::size_t frames_ = 0, notLater_ = 0;
    std::map<std::string, double> lastOf_;
};

}  // namespace terratact
