#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/series/series_summary.h"

namespace terratact {

/// What a plot shows of one signal in a span of time.
struct SeriesView {
    std::vector<SeriesColumn> columns{};  ///< by time; columns without samples are left out
    double breakAfter = 0.0;              ///< [s] a line does not bridge a longer pause
    SeriesSummary visible{};              ///< of the samples in the span
    std::optional<double> before{};       ///< newest value up to the span; empty: none
    std::optional<double> atCursor{};     ///< newest value up to the cursor; empty: none
};

/// Returns the view in another unit: every value times `factor`, which is > 0.
inline SeriesView times(SeriesView view, double factor)
{
    for (SeriesColumn& column : view.columns) column.summary = column.summary.times(factor);
    view.visible = view.visible.times(factor);
    if (view.before) *view.before *= factor;
    if (view.atCursor) *view.atCursor *= factor;
    return view;
}

/// Returns the longest pause that a line bridges [s]. It is five usual intervals of the samples.
/// It is at least two and a half columns of the plot, and as many of the series.
inline double bridgedPause(double usualInterval, double column, double bucket)
{
    return std::max({5.0 * usualInterval, 2.5 * column, 2.5 * bucket});
}

/// Returns the view of a BucketPyramid or a SignalSeries. resolution: [s] of its buckets in this span.
template <class Series>
SeriesView viewOf(const Series& series, double from, double to, std::size_t columns, double cursor,
                  double resolution)
{
    const ColumnGrid grid = columnGrid(from, to, columns);
    const auto first = series.first(), last = series.last();
    const double interval =
        series.count() > 1 ? (*last - *first) / static_cast<double>(series.count() - 1) : 0.0;
    return {.columns = series.columns(grid),
            .breakAfter = bridgedPause(interval, grid.width, resolution),
            .visible = series.over(from, to),
            .before = series.valueAt(from),
            .atCursor = series.valueAt(cursor)};
}

}  // namespace terratact
