#include "core/series/series_summary.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {

void SeriesSummary::add(double value)
{
    low = count == 0 ? value : std::min(low, value);
    high = count == 0 ? value : std::max(high, value);
    ++count;
    const double off = value - mean;
    mean += off / static_cast<double>(count);
    squares += off * (value - mean);
    last = value;
}

void SeriesSummary::append(const SeriesSummary& later)
{
    if (later.count == 0) return;
    if (count == 0) {
        *this = later;
        return;
    }
    const auto n = static_cast<double>(count), m = static_cast<double>(later.count);
    const double off = later.mean - mean;
    mean += off * m / (n + m);
    squares += later.squares + off * off * n * m / (n + m);
    low = std::min(low, later.low);
    high = std::max(high, later.high);
    last = later.last;
    count += later.count;
}

SeriesSummary SeriesSummary::times(double factor) const
{
    return {.mean = factor * mean,
            .squares = factor * factor * squares,
            .last = factor * last,
            .low = factor * low,
            .high = factor * high,
            .count = count};
}

double SeriesSummary::sd() const
{
    return count < 2 ? 0.0 : std::sqrt(std::max(0.0, squares) / static_cast<double>(count - 1));
}

ColumnGrid columnGrid(double from, double to, std::size_t count)
{
    if (!std::isfinite(from) || !std::isfinite(to) || !(from < to) || count < 2)
        throw std::invalid_argument("columnGrid: needs finite from < to and at least two columns");
    const double width = (to - from) / static_cast<double>(count - 1);
    return {std::floor(from / width) * width, width, count};
}

}  // namespace terratact
