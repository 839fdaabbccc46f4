#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/series/bucket_pyramid.h"

namespace terratact {

/// A running signal in fixed memory: its newest samples one by one, and all of them in buckets. A short span of the
/// newest samples is exact; a longer or older one has the resolution of the buckets.
class SignalSeries {
public:
    static constexpr std::size_t kRecent = 16'384;   ///< samples kept one by one
    static constexpr std::size_t kBuckets = 16'384;  ///< buckets of the whole run
    static constexpr double kFinest = 0.02;          ///< [s] width of a bucket at the start

    /// begin: earliest time of a sample [s].
    explicit SignalSeries(double begin) : pyramid_(begin, kFinest, kBuckets) {}

    /// Adds a sample; one that is not finite is left out. An older time than that of the last sample counts as that.
    void add(double time, double value);

    std::uint64_t count() const { return pyramid_.count(); }
    std::optional<double> first() const { return pyramid_.first(); }
    std::optional<double> last() const { return pyramid_.last(); }
    /// Returns the resolution of a span from this time on [s]; 0: every sample is kept.
    double resolutionFrom(double time) const { return time < exactFrom() ? pyramid_.width() : 0.0; }
    /// Returns the time from which on every sample is kept [s]; infinity without samples.
    double exactFrom() const;

    /// Return what BucketPyramid returns, from single samples where they are kept.
    std::vector<SeriesColumn> columns(const ColumnGrid& grid) const;
    SeriesSummary over(double from, double to) const;
    std::optional<double> valueAt(double time) const;

private:
    struct Sample {
        double time, value;
    };
    const Sample& at(std::size_t i) const { return recent_[(oldest_ + i) % recent_.size()]; }
    std::size_t firstAt(double time) const;  ///< index of the first sample at `time` or later

    BucketPyramid pyramid_;
    std::vector<Sample> recent_;  // a ring once it is full
    std::size_t oldest_ = 0;
};

}  // namespace terratact
