#include "core/mapping/telemetry_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace terratact {
namespace {

/// Reads one series at rising times.
class SeriesAt {
public:
    SeriesAt(const Series& series, double maxGap, bool isAngle)
        : series_(series), maxGap_(static_cast<std::int64_t>(maxGap * 1e9)), isAngle_(isAngle)
    {
    }

    std::optional<double> at(std::int64_t time)
    {
        while (next_ < series_.size() && series_[next_].time <= time) ++next_;
        if (next_ == 0) return std::nullopt;
        const SeriesSample& before = series_[next_ - 1];
        if (!before.isMeasured) return std::nullopt;
        if (before.time == time) return before.value;
        if (next_ == series_.size())
            return time - before.time <= maxGap_ ? std::optional(before.value) : std::nullopt;
        const SeriesSample& after = series_[next_];
        if (!after.isMeasured || after.time - before.time > maxGap_) return std::nullopt;
        const double share =
            static_cast<double>(time - before.time) / static_cast<double>(after.time - before.time);
        const double step =
            isAngle_ ? turnBetween(before.value, after.value) : after.value - before.value;
        return before.value + share * step;
    }

    /// Returns the newest value up to the time.
    std::optional<double> last(std::int64_t time)
    {
        while (next_ < series_.size() && series_[next_].time <= time) ++next_;
        return next_ > 0 ? std::optional(series_[next_ - 1].value) : std::nullopt;
    }

private:
    const Series& series_;
    std::int64_t maxGap_;
    bool isAngle_;
    std::size_t next_ = 0;  ///< first sample later than the last time
};

bool isAngle(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Pitch:
    case Quantity::Roll:
    case Quantity::FrontLeft:
    case Quantity::FrontRight:
    case Quantity::RearLeft:
    case Quantity::RearRight:
    case Quantity::Turned:
    case Quantity::Differential: return true;
    default: return false;
    }
}

std::vector<std::int64_t> lineTimes(const Series& pitch, double rate)
{
    std::vector<std::int64_t> times;
    times.reserve(pitch.size());
    const auto period = rate > 0.0 ? static_cast<std::int64_t>(1e9 / rate) : 0;
    for (const SeriesSample& sample : pitch) {
        if (!sample.isMeasured) continue;
        if (!times.empty() && sample.time - times.back() < std::max<std::int64_t>(period, 1))
            continue;
        times.push_back(sample.time);
    }
    return times;
}

class LineMaker {
public:
    LineMaker(const RecordedSeries& series, const Mapping& mapping)
    {
        at_.reserve(kQuantities);
        for (std::size_t q = 0; q < kQuantities; ++q)
            at_.emplace_back(series.of[q], mapping.maxGap, isAngle(static_cast<Quantity>(q)));
        for (const auto& side : series.forces)
            for (const Series& element : side) forces_.emplace_back(element, mapping.maxGap, false);
    }

    std::optional<TelemetryLine> line(std::int64_t time)
    {
        Measurement m;
        const auto pitch = at(Quantity::Pitch, time), frontLeft = at(Quantity::FrontLeft, time),
                   frontRight = at(Quantity::FrontRight, time),
                   rearLeft = at(Quantity::RearLeft, time),
                   rearRight = at(Quantity::RearRight, time);
        if (!pitch || !frontLeft || !frontRight || !rearLeft || !rearRight) return std::nullopt;
        m.pitch = *pitch;
        m.roll = at(Quantity::Roll, time).value_or(0.0);
        m.frontLeft = *frontLeft;
        m.frontRight = *frontRight;
        m.rearLeft = *rearLeft;
        m.rearRight = *rearRight;
        setCurrents(m, {at(Quantity::FrontLeftCurrent, time), at(Quantity::FrontRightCurrent, time),
                        at(Quantity::RearLeftCurrent, time), at(Quantity::RearRightCurrent, time)});
        SideForces front;
        for (std::size_t e = 0; e < kForceElements; ++e) {
            front.left[e] = force(0, e, time);
            front.right[e] = force(1, e, time);
            m.rearSides.left[e] = force(2, e, time);
            m.rearSides.right[e] = force(3, e, time);
        }
        setSides(m, front);
        m.travelled = at(Quantity::Travelled, time);
        m.turned = at(Quantity::Turned, time);
        m.differential = at(Quantity::Differential, time);
        m.activity = word<RobotActivity>(Quantity::Activity, RobotActivity::Stopped, time);
        m.refusal = word<Refusal>(Quantity::Refusal, Refusal::OutOfLimits, time);
        return TelemetryLine{time, m};
    }

private:
    SeriesAt& series(Quantity q) { return at_[static_cast<std::size_t>(q)]; }
    std::optional<double> at(Quantity q, std::int64_t time) { return series(q).at(time); }

    std::optional<double> force(std::size_t side, std::size_t element, std::int64_t time)
    {
        return forces_[side * kForceElements + element].at(time);
    }

    template <class Enum>
    Enum word(Quantity q, Enum last, std::int64_t time)
    {
        const double value = series(q).last(time).value_or(0.0);
        const bool isOne = value >= 0.0 && value <= static_cast<double>(last);
        return isOne ? static_cast<Enum>(static_cast<int>(value)) : Enum{};
    }

    std::vector<SeriesAt> at_;
    std::vector<SeriesAt> forces_;
};

/// Sets the activity of lines by motion and by the rule of presses.
void addActivity(std::vector<TelemetryLine>& lines, const PressRule& rule)
{
    const std::vector<bool> moved = movedAt(lines, rule);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Measurement& m = lines[i].measurement;
        if (moved[i])
            m.activity = RobotActivity::Driving;
        else
            m.activity = presses(m, rule) ? RobotActivity::Pressed : RobotActivity::Halted;
    }
}

}  // namespace

std::vector<TelemetryLine> telemetryLines(const RecordedSeries& series, const Mapping& mapping)
{
    const std::vector<std::int64_t> times = lineTimes(series.series(Quantity::Pitch), mapping.rate);
    LineMaker maker(series, mapping);
    std::vector<TelemetryLine> lines;
    lines.reserve(times.size());
    for (const std::int64_t time : times)
        if (const auto line = maker.line(time)) lines.push_back(*line);
    if (series.series(Quantity::Activity).empty()) addActivity(lines, mapping.scenes);
    return lines;
}

}  // namespace terratact
