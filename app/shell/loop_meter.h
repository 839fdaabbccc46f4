#pragma once

#include <cstddef>
#include <vector>

namespace terratact {

/// Quantiles of the newest values.
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
    /// Returns the smallest value such that a share of at least p does not exceed it; 0 without values. Throws
    /// std::invalid_argument unless 0 ≤ p ≤ 1.
    double quantile(double p) const;
    double most() const { return quantile(1.0); }
    std::size_t count() const { return values_.size(); }

private:
    std::size_t room_;
    std::vector<double> values_;
    std::size_t next_ = 0;
};

/// Measures the window's responsiveness over the last minute [s]. It records lateness of the event loop, cost of a
/// frame, and age of telemetry when shown. It has no clock.
class LoopMeter {
public:
    static constexpr double kMinute = 60.0;  ///< [s]

    /// period: interval of beat() [s].
    explicit LoopMeter(double period);

    void beat(double now);  ///< call when the timer fires
    /// Call after a frame was prepared and painted. seconds: its cost. latency: time since its newest telemetry
    /// arrived; negative if it shows nothing new.
    void frame(double seconds, double latency);

    /// Returns the delays of beat(): the waiting time of an event.
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
