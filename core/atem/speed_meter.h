#pragma once

#include <deque>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Speed along the tracks: the way of the last kWindow seconds of telemetry, divided by its time. It
/// has no clock; memory is bounded.
class SpeedMeter {
public:
    static constexpr double kWindow = 0.5;  ///< [s]
    /// [s] a line that follows sooner is ignored: at most 51 lines are kept.
    static constexpr double kSpacing = 0.01;

    /// Reads the next line of telemetry. A line without odometry, a jump of the clock, or a silence
    /// longer than kMaxSilence begins anew.
    void add(const Measurement& line)
    {
        if (!line.travelled) return lines_.clear();
        if (!lines_.empty()) {
            const double since = line.time - lines_.back().time;
            if (since < 0.0 || since > kMaxSilence)
                lines_.clear();
            else if (since < kSpacing)
                return;
        }
        lines_.push_back({line.time, *line.travelled});
        while (lines_.size() > 2 && line.time - lines_[1].time >= kWindow) lines_.pop_front();
    }
    void clear() { lines_.clear(); }

    /// Returns the speed [m/s], forward positive; empty: there are no two lines.
    std::optional<double> speed() const
    {
        if (lines_.size() < 2) return std::nullopt;
        return (lines_.back().way - lines_.front().way)
             / (lines_.back().time - lines_.front().time);
    }

private:
    struct Line {
        double time, way;
    };
    std::deque<Line> lines_;
};

}  // namespace terratact
