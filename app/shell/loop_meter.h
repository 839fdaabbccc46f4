#pragma once

#include <cstddef>
#include <vector>

namespace terratact {

/// Quantiles of the newest so many values.
class NewestValues {
public:
    explicit NewestValues(std::size_t room) : room_(room) { values_.reserve(room); }

    void add(double value)
    {
        if (values_.size() < room_)
            values_.push_back(value);
        else
            values_[next_] = value;
        next_ = (next_ + 1) % room_;
    }
    /// The least value that a share of at least p does not exceed; 0 where there is none.  Throws
    /// std::invalid_argument unless 0 ≤ p ≤ 1.
    double quantile(double p) const;
    double most() const { return quantile(1.0); }
    std::size_t count() const { return values_.size(); }

private:
    std::size_t room_;
    std::vector<double> values_;
    std::size_t next_ = 0;
};

/// Whether a window keeps up: how late its event loop is, what a frame costs, how old telemetry is when it
/// is on the screen.  Over the last minute, all in [s].  No clock.
class LoopMeter {
public:
    static constexpr double kMinute = 60.0;  ///< [s]

    /// period: [s] at which beat() is due.
    explicit LoopMeter(double period);

    void beat(double now);  ///< the timer fires
    /// A frame was prepared and painted in so many seconds; latency: since the newest telemetry in it came,
    /// below 0 where it shows none that is new.
    void frame(double seconds, double latency);

    /// By how much beats came too late: what an event had to wait for.
    const NewestValues& lateness() const { return lateness_; }
    const NewestValues& frames() const { return frames_; }
    const NewestValues& latencies() const { return latencies_; }

private:
    double period_;
    double last_ = 0.0;
    bool began_ = false;
    NewestValues lateness_, frames_, latencies_;
};

}  // namespace terratact
