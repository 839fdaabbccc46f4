#pragma once

#include <cstdint>
#include <vector>

namespace terratact {

/// Summary of samples. Without samples, all values are 0 and have no meaning.
struct SeriesSummary {
    double mean = 0.0;
    double squares = 0.0;  ///< sum of (value − mean)²
    double last = 0.0;     ///< newest value
    double low = 0.0, high = 0.0;
    std::uint64_t count = 0;  ///< number of samples

    /// Adds one finite value, the newest.  Source: Welford (1962).
    void add(double value);
    /// Adds samples that follow these ones.  Source: Chan, Golub and LeVeque (1979).
    void append(const SeriesSummary& later);
    /// Returns the summary of the same samples in another unit: each times `factor`, which is > 0.
    SeriesSummary times(double factor) const;
    /// Returns the standard deviation of the samples, with count − 1; 0 for fewer than two samples.
    double sd() const;
    bool operator==(const SeriesSummary&) const = default;
};

/// The samples of one column of a plot.
struct SeriesColumn {
    double time = 0.0;  ///< [s] middle of the column
    SeriesSummary summary;
    bool operator==(const SeriesColumn&) const = default;
};

/// Equal columns from `begin` on; column i covers begin + i · width … begin + (i + 1) · width.
struct ColumnGrid {
    double begin = 0.0, width = 1.0;  ///< [s]
    std::size_t count = 0;

    double end() const { return begin + width * static_cast<double>(count); }
};

/// Returns at most `count` columns that cover from … to. Their grid does not depend on `from`. So a
/// sample stays in its column while the range moves. Throws std::invalid_argument unless from < to
/// are finite and count ≥ 2.
ColumnGrid columnGrid(double from, double to, std::size_t count);

}  // namespace terratact
