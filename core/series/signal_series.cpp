#include "core/series/signal_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terratact {

void SignalSeries::add(double time, double value)
{
    if (!std::isfinite(time) || !std::isfinite(value)) return;
    const double at = std::max(time, pyramid_.last().value_or(time));
    const std::uint64_t before = pyramid_.count();
    pyramid_.add(at, value);
    if (pyramid_.count() == before) return;
    if (recent_.size() < kRecent) {
        if (recent_.capacity() == 0) recent_.reserve(kRecent);
        recent_.push_back({at, value});
        return;
    }
    recent_[oldest_] = {at, value};
    oldest_ = (oldest_ + 1) % kRecent;
}

double SignalSeries::exactFrom() const
{
    if (recent_.empty()) return std::numeric_limits<double>::infinity();
    return recent_.size() < kRecent ? pyramid_.begin() : at(0).time;
}

std::size_t SignalSeries::firstAt(double time) const
{
    std::size_t low = 0, high = recent_.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (at(middle).time < time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::vector<SeriesColumn> SignalSeries::columns(const ColumnGrid& grid) const
{
    constexpr double kEnough = 4.0;  // buckets in a column, of which its ends are a small part
    if (grid.begin < exactFrom() || grid.width >= kEnough * pyramid_.width())
        return pyramid_.columns(grid);
    std::vector<SeriesColumn> columns;
    columns.reserve(grid.count);
    const std::size_t end = firstAt(grid.end());
    double shown = -1.0;
    for (std::size_t i = firstAt(grid.begin); i < end; ++i) {
        const double column = std::floor((at(i).time - grid.begin) / grid.width);
        if (columns.empty() || column > shown) {
            columns.push_back({grid.begin + (column + 0.5) * grid.width, {}});
            shown = column;
        }
        columns.back().summary.add(at(i).value);
    }
    return columns;
}

SeriesSummary SignalSeries::over(double from, double to) const
{
    constexpr double kEnough = 4000.0;  // buckets, of which the ends are a small part
    if (!(from < to)) return {};
    if (from < exactFrom() || to - from >= kEnough * pyramid_.width())
        return pyramid_.over(from, to);
    SeriesSummary sum;
    const std::size_t end = firstAt(to);
    for (std::size_t i = firstAt(from); i < end; ++i) sum.add(at(i).value);
    return sum;
}

std::optional<double> SignalSeries::valueAt(double time) const
{
    if (time < exactFrom()) return pyramid_.valueAt(time);
    std::size_t next = firstAt(time);
    while (next < recent_.size() && at(next).time <= time) ++next;
    return next > 0 ? std::optional(at(next - 1).value) : pyramid_.valueAt(time);
}

}  // namespace terratact
