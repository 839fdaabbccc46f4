#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Speed along the tracks: the way of the last kWindow seconds of telemetry, divided by its time. Zero
/// as soon as the way has not changed for kStill. It has no clock; memory is bounded.
class SpeedMeter {
public:
    static constexpr double kWindow = 0.3;   ///< [s]
    static constexpr double kStill = 0.09;   ///< [s] two cycles of 20 Hz, with their jitter
    static constexpr double kStep = 0.5e-3;  ///< [m] half a step of the bus; less is no way
    static constexpr double kFastest = 5.0;  ///< [m/s] a faster way is a reset of the odometry
    /// [s] a line that follows sooner is ignored: at most 31 lines are kept.
    static constexpr double kSpacing = 0.01;

    /// Reads the next line of telemetry. A line without odometry, or a jump of the clock or
    /// odometry, restarts the measurement. So does a silence longer than kMaxSilence.
    void add(const Measurement& line)
    {
        if (!line.travelled || !std::isfinite(*line.travelled)) return lines_.clear();
        if (!lines_.empty()) {
            const double since = line.time - lines_.back().time;
            const double way = std::abs(*line.travelled - lines_.back().way);
            if (since >= 0.0 && since < kSpacing) return;
            if (since < 0.0 || since > kMaxSilence || way > kFastest * since) lines_.clear();
        }
        lines_.push_back({line.time, *line.travelled});
        const double window = isStill() ? kStill : kWindow;
        while (lines_.size() > 2 && line.time - lines_[1].time >= window) lines_.pop_front();
    }
    void clear() { lines_.clear(); }

    /// Returns the speed [m/s], forward positive; empty: there are no two lines.
    std::optional<double> speed() const
    {
        if (lines_.size() < 2) return std::nullopt;
        if (isStill()) return 0.0;
        return (lines_.back().way - lines_.front().way)
             / (lines_.back().time - lines_.front().time);
    }

private:
    struct Line {
        double time, way;
    };

    /// Returns true if the newest lines hold the same way for kStill or longer.
    bool isStill() const
    {
        const Line& newest = lines_.back();
        for (std::size_t i = lines_.size(); i-- > 0;) {
            if (std::abs(lines_[i].way - newest.way) > kStep) return false;
            if (newest.time - lines_[i].time >= kStill) return true;
        }
        return false;
    }

    std::deque<Line> lines_;
};

}  // namespace terratact
