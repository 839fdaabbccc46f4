#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace terratact {

/// Makes an even clock of the times of a log, which jump where the recording machine's clock was set: back, or forward
/// by more than kMaxSilence (a machine without a clock of its own begins in 1970).  Frames of
/// different interfaces may come up to kDisorder out of order, those of one up to kJitter.
class LogClock {
public:
    static constexpr double kMaxSilence = 3660.0 * 86'400.0;  ///< [s]
    static constexpr double kDisorder = 0.1, kJitter = 1e-3;  ///< [s]
    static constexpr std::size_t kMaxInterfaces = 64;         ///< whose order is watched

    /// The next frame's time [s].  By how much it lies before the one before it, negative for a jump forward; empty: it
    /// goes on.
    std::optional<double> take(double time, const std::string& interface);

    /// [s] since the first frame: never less than before.  After a jump it goes on from where it was.
    double elapsed() const { return elapsed_; }

    std::size_t frames() const { return frames_; }
    std::size_t notLater() const { return notLater_; }  ///< frames whose time did not grow
    std::optional<double> first() const { return first_; }

private:
    std::optional<double> first_;
    double base_ = 0.0, elapsed_ = 0.0, last_ = 0.0;
    std::size_t frames_ = 0, notLater_ = 0;
    std::map<std::string, double> lastOf_;
};

}  // namespace terratact
