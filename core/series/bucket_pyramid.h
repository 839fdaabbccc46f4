#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/series/series_summary.h"

namespace terratact {

/// Samples of any number in a fixed number of buckets of equal width. A sample behind the last bucket doubles the
/// width: neighbours become one bucket. Level k of the pyramid has buckets of width · 2^k, so a summary of any span
/// visits few buckets. Memory is 64 bytes for each bucket of the finest level, from the start on.
class BucketPyramid {
public:
    /// begin: time of the first bucket [s]; earlier samples are left out. width: of a bucket at the start [s].
    /// buckets: a power of two, at least 64. Throws std::invalid_argument for other values.
    BucketPyramid(double begin, double width, std::size_t buckets);

    /// Adds a sample; one that is not finite is left out. A sample may be older than the last one.
    void add(double time, double value);

    double begin() const { return begin_; }
    double width() const { return width_; }  ///< [s] of a bucket of the finest level
    std::uint64_t count() const { return all_.count; }
    /// Return the times of the first and the last sample [s]; empty: there is none.
    std::optional<double> first() const;
    std::optional<double> last() const;

    /// Returns the columns of the grid that have samples. A bucket belongs to the column of its middle. Columns
    /// narrower than a bucket share none: some are missing.
    std::vector<SeriesColumn> columns(const ColumnGrid& grid) const;
    /// Returns the summary of the buckets whose middle is in from … to.
    SeriesSummary over(double from, double to) const;
    /// Returns the newest value up to the bucket of `time`; empty: there is none.
    std::optional<double> valueAt(double time) const;

private:
    /// 32 bytes, some of them in single precision: a plot shows no more digits.
    struct Bucket {
        double mean = 0.0;
        double squares = 0.0;
        float last = 0.0F, low = 0.0F, high = 0.0F;
        std::uint32_t count = 0;
    };
    static SeriesSummary summaryOf(const Bucket& bucket);
    static Bucket bucketOf(const SeriesSummary& summary);
    static void append(Bucket& bucket, const Bucket& later);
    void coarsen();
    std::size_t firstIndex(double time, std::size_t level) const;
    std::optional<std::size_t> lastFilled(std::size_t level, std::size_t index) const;

    double begin_, width_;
    std::vector<std::vector<Bucket>> levels_;  // level k has buckets / 2^k buckets
    SeriesSummary all_;
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace terratact
