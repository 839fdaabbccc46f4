#include "core/series/bucket_pyramid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr std::size_t kMinBuckets = 64;
constexpr double kWidest = 1e9;  // [s] of a bucket: longer than any run

}  // namespace

BucketPyramid::BucketPyramid(double begin, double width, std::size_t buckets)
    : begin_(begin), width_(width)
{
    if (!std::isfinite(begin) || !(width > 0.0) || !std::isfinite(width))
        throw std::invalid_argument("BucketPyramid: begin and a width above 0 must be finite");
    if (buckets < kMinBuckets || !std::has_single_bit(buckets))
        throw std::invalid_argument("BucketPyramid: buckets must be a power of two, at least 64");
    for (std::size_t n = buckets; n >= 1; n /= 2) levels_.emplace_back(n);
}

SeriesSummary BucketPyramid::summaryOf(const Bucket& bucket)
{
    return {.mean = bucket.mean,
            .squares = bucket.squares,
            .last = static_cast<double>(bucket.last),
            .low = static_cast<double>(bucket.low),
            .high = static_cast<double>(bucket.high),
            .count = bucket.count};
}

BucketPyramid::Bucket BucketPyramid::bucketOf(const SeriesSummary& summary)
{
    constexpr std::uint64_t kMaxBucketCount = std::numeric_limits<std::uint32_t>::max();
    return {.mean = summary.mean,
            .squares = summary.squares,
            .last = static_cast<float>(summary.last),
            .low = static_cast<float>(summary.low),
            .high = static_cast<float>(summary.high),
            .count = static_cast<std::uint32_t>(std::min(summary.count, kMaxBucketCount))};
}

void BucketPyramid::append(Bucket& bucket, const Bucket& later)
{
    SeriesSummary sum = summaryOf(bucket);
    sum.append(summaryOf(later));
    bucket = bucketOf(sum);
}

void BucketPyramid::add(double time, double value)
{
    // A bucket holds single precision: larger numbers have no place in a plot.
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (!std::isfinite(time) || !std::isfinite(value) || std::abs(value) > kLargest) return;
    if (time < begin_) return;
    const auto place = [&] { return (time - begin_) / width_; };
    const auto buckets = static_cast<double>(levels_.front().size());
    while (place() >= buckets) {
        if (width_ > kWidest) return;
        coarsen();
    }
    auto index = static_cast<std::size_t>(place());
    for (std::vector<Bucket>& level : levels_) {
        SeriesSummary sum = summaryOf(level[index]);
        sum.add(value);
        level[index] = bucketOf(sum);
        index /= 2;
    }
    all_.add(value);
    first_ = std::min(first_, time);
    last_ = std::max(last_, time);
}

/// Doubles the width: each level takes the buckets of the next one.
void BucketPyramid::coarsen()
{
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
        std::vector<Bucket>& level = levels_[k];
        const std::vector<Bucket>& next = levels_[k + 1];
        std::copy(next.begin(), next.end(), level.begin());
        std::fill(level.begin() + static_cast<std::ptrdiff_t>(next.size()), level.end(), Bucket{});
    }
    width_ *= 2.0;
}

std::optional<double> BucketPyramid::first() const
{
    return all_.count > 0 ? std::optional(first_) : std::nullopt;
}

std::optional<double> BucketPyramid::last() const
{
    return all_.count > 0 ? std::optional(last_) : std::nullopt;
}

/// Returns the first bucket of the level whose middle is at `time` or later, at most one behind the last.
std::size_t BucketPyramid::firstIndex(double time, std::size_t level) const
{
    const double width = std::ldexp(width_, static_cast<int>(level));
    const double index = std::ceil((time - begin_) / width - 0.5);
    const auto size = static_cast<double>(levels_[level].size());
    return static_cast<std::size_t>(std::clamp(index, 0.0, size));
}

std::vector<SeriesColumn> BucketPyramid::columns(const ColumnGrid& grid) const
{
    // The coarsest level of which every column still has at least four buckets.
    std::size_t level = 0;
    while (level + 1 < levels_.size()
           && 4.0 * std::ldexp(width_, static_cast<int>(level) + 1) <= grid.width)
        ++level;
    std::vector<SeriesColumn> columns;
    columns.reserve(grid.count);
    const std::size_t filled = all_.count > 0 ? firstIndex(last_, level) + 1 : 0;
    const std::size_t end =
        std::min({levels_[level].size(), firstIndex(grid.end(), level), filled});
    std::size_t index = firstIndex(grid.begin, level);
    const double width = std::ldexp(width_, static_cast<int>(level));
    while (index < end) {
        const double middle = begin_ + (static_cast<double>(index) + 0.5) * width;
        const double column = std::floor((middle - grid.begin) / grid.width);
        const std::size_t next = std::max(
            index + 1, std::min(end, firstIndex(grid.begin + (column + 1.0) * grid.width, level)));
        SeriesSummary sum;
        for (; index < next; ++index) sum.append(summaryOf(levels_[level][index]));
        if (sum.count > 0) columns.push_back({grid.begin + (column + 0.5) * grid.width, sum});
    }
    return columns;
}

SeriesSummary BucketPyramid::over(double from, double to) const
{
    SeriesSummary sum;
    if (!(from < to) || all_.count == 0) return sum;
    std::size_t index = firstIndex(from, 0);
    const std::size_t end = firstIndex(to, 0);
    // Takes the largest bucket that begins at `index` and ends within the span.
    while (index < end) {
        std::size_t level = 0;
        while (level + 1 < levels_.size() && (index >> level) % 2 == 0
               && index + (std::size_t{2} << level) <= end)
            ++level;
        sum.append(summaryOf(levels_[level][index >> level]));
        index += std::size_t{1} << level;
    }
    return sum;
}

/// Returns the last bucket up to `index` that has samples.
std::optional<std::size_t> BucketPyramid::lastFilled(std::size_t level, std::size_t index) const
{
    // Climbs until a bucket to the left has samples, then descends into its newest part.
    std::size_t k = level, i = index;
    if (levels_[k][i].count > 0) return i;
    for (; k < levels_.size(); ++k, i /= 2) {
        if (i % 2 == 0 || levels_[k][i - 1].count == 0) continue;
        --i;
        for (; k > level; --k) i = levels_[k - 1][2 * i + 1].count > 0 ? 2 * i + 1 : 2 * i;
        return i;
    }
    return std::nullopt;
}

std::optional<double> BucketPyramid::valueAt(double time) const
{
    if (all_.count == 0 || !(time >= begin_)) return std::nullopt;
    const auto last = static_cast<double>(levels_.front().size() - 1);
    const auto index =
        static_cast<std::size_t>(std::min(last, std::floor((time - begin_) / width_)));
    const auto found = lastFilled(0, index);
    if (!found) return std::nullopt;
    return static_cast<double>(levels_.front()[*found].last);
}

}  // namespace terratact
