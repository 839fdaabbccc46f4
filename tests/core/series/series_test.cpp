// Tests the memory of plots against the samples themselves: summaries, buckets, exact spans.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/series/series_view.h"
#include "core/series/signal_series.h"

namespace terratact {
namespace {

struct PlainSample {
    double time, value;
};

std::vector<PlainSample> wave(std::size_t count, double step)
{
    std::mt19937_64 rng(5);
    std::vector<PlainSample> samples;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double noise = static_cast<double>(rng() >> 11U) * 0x1p-53;
        const double t = step * static_cast<double>(i);
        samples.push_back({t, std::sin(0.01 * t) + 0.1 * noise});
    }
    return samples;
}

SeriesSummary plainSummary(const std::vector<PlainSample>& samples, double from, double to)
{
    SeriesSummary sum;
    for (const PlainSample& s : samples)
        if (s.time >= from && s.time < to) sum.add(s.value);
    return sum;
}

TEST(SeriesSummary, joinedHalvesAreTheWhole)
{
    SeriesSummary whole, first, second, empty;
    const std::vector<double> values{3.0, -1.0, 4.0, 1.5, -9.0, 2.6};
    for (std::size_t i = 0; i < values.size(); ++i) {
        whole.add(values[i]);
        (i < 2 ? first : second).add(values[i]);
    }
    first.append(empty);
    first.append(second);
    EXPECT_EQ(first.count, 6U);
    EXPECT_NEAR(first.mean, whole.mean, 1e-12);
    EXPECT_NEAR(first.sd(), whole.sd(), 1e-12);
    EXPECT_EQ(first.low, -9.0);
    EXPECT_EQ(first.high, 4.0);
    EXPECT_EQ(first.last, 2.6);
    double squares = 0.0;
    for (const double v : values) squares += (v - whole.mean) * (v - whole.mean);
    EXPECT_NEAR(whole.sd(), std::sqrt(squares / 5.0), 1e-12);
    empty.append(second);
    EXPECT_EQ(empty, second);
    EXPECT_EQ(SeriesSummary().sd(), 0.0);
}

TEST(ColumnGrid, keepsItsColumnsWhileTheRangeMoves)
{
    const ColumnGrid grid = columnGrid(100.3, 110.3, 501);
    EXPECT_LE(grid.begin, 100.3);
    EXPECT_GE(grid.end(), 110.3);
    const double moved = 5.3 * grid.width;
    const double columns =
        (columnGrid(100.3 + moved, 110.3 + moved, 501).begin - grid.begin) / grid.width;
    EXPECT_NEAR(columns, std::round(columns), 1e-6);
    EXPECT_GE(columns, 5.0 - 1e-6);
    EXPECT_THROW(columnGrid(1.0, 1.0, 10), std::invalid_argument);
    EXPECT_THROW(columnGrid(0.0, std::numeric_limits<double>::infinity(), 10),
                 std::invalid_argument);
    EXPECT_THROW(columnGrid(0.0, 1.0, 1), std::invalid_argument);
}

TEST(BucketPyramid, summarisesAnySpanOfALongRun)
{
    const auto samples = wave(200'000, 0.005);  // 1000 s into 64 s of buckets: doubled four times
    BucketPyramid pyramid(0.0, 0.0625, 1024);
    for (const PlainSample& s : samples) pyramid.add(s.time, s.value);
    EXPECT_EQ(pyramid.width(), 1.0);
    EXPECT_EQ(pyramid.count(), samples.size());
    EXPECT_EQ(pyramid.first(), 0.0);
    EXPECT_EQ(pyramid.last(), samples.back().time);
    for (const auto& [from, to] :
         {std::pair{0.0, 1000.0}, {0.0, 1.0}, {17.0, 18.0}, {3.0, 997.0}, {511.0, 513.0}}) {
        const SeriesSummary expected = plainSummary(samples, from, to);
        const SeriesSummary found = pyramid.over(from, to);
        EXPECT_EQ(found.count, expected.count) << from << " … " << to;
        EXPECT_NEAR(found.mean, expected.mean, 1e-9);
        EXPECT_NEAR(found.sd(), expected.sd(), 1e-9);
        EXPECT_FLOAT_EQ(static_cast<float>(found.low), static_cast<float>(expected.low));
        EXPECT_FLOAT_EQ(static_cast<float>(found.high), static_cast<float>(expected.high));
    }
    EXPECT_EQ(pyramid.over(5.0, 5.0).count, 0U);
}

TEST(BucketPyramid, columnsLoseNoSampleAndNoPeak)
{
    auto samples = wave(50'000, 0.01);
    samples[31'234].value = 99.0;
    BucketPyramid pyramid(0.0, 0.01, 65'536);
    for (const PlainSample& s : samples) pyramid.add(s.time + 0.005, s.value);
    for (const std::size_t count : {5U, 40U, 1000U, 20'000U}) {
        const auto columns = pyramid.columns(columnGrid(0.0, 500.0, count));
        EXPECT_LE(columns.size(), count);
        std::uint64_t all = 0;
        double high = 0.0, before = -1.0;
        for (const SeriesColumn& c : columns) {
            all += c.summary.count;
            high = std::max(high, c.summary.high);
            EXPECT_GT(c.time, before);
            before = c.time;
        }
        EXPECT_EQ(all, samples.size()) << count;
        EXPECT_EQ(high, 99.0) << count;
    }
    EXPECT_TRUE(pyramid.columns(columnGrid(600.0, 700.0, 100)).empty());
}

TEST(BucketPyramid, findsTheNewestValueBeforeATime)
{
    BucketPyramid pyramid(0.0, 1.0, 64);
    EXPECT_FALSE(pyramid.valueAt(5.0));
    for (const double t : {3.5, 4.5, 40.5}) pyramid.add(t, t);
    EXPECT_FALSE(pyramid.valueAt(2.0));
    EXPECT_FALSE(pyramid.valueAt(-7.0));
    EXPECT_EQ(pyramid.valueAt(3.9), 3.5);
    EXPECT_EQ(pyramid.valueAt(39.0), 4.5);
    EXPECT_EQ(pyramid.valueAt(32.0), 4.5);
    EXPECT_EQ(pyramid.valueAt(1e12), 40.5);
}

TEST(BucketPyramid, takesHostileSamplesInItsStride)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    BucketPyramid pyramid(10.0, 0.1, 64);
    pyramid.add(9.0, 1.0);
    pyramid.add(11.0, kInfinity);
    pyramid.add(11.0, std::nan(""));
    pyramid.add(11.0, 1e300);
    pyramid.add(std::nan(""), 1.0);
    pyramid.add(1e300, 1.0);
    EXPECT_EQ(pyramid.count(), 0U);
    EXPECT_THROW(BucketPyramid(0.0, 0.1, 100), std::invalid_argument);
    EXPECT_THROW(BucketPyramid(0.0, 0.0, 64), std::invalid_argument);
    EXPECT_THROW(BucketPyramid(0.0, 0.1, 32), std::invalid_argument);
}

TEST(SignalSeries, showsTheNewestSamplesOneByOne)
{
    const auto samples = wave(100'000, 0.001);
    SignalSeries series(0.0);
    for (const PlainSample& s : samples) series.add(s.time, s.value);
    EXPECT_NEAR(series.exactFrom(), 100.0 - 16.384, 1e-3);
    const ColumnGrid grid = columnGrid(99.5, 99.6, 101);  // 1 ms columns
    const auto columns = series.columns(grid);
    EXPECT_GE(columns.size(), 100U);
    for (const SeriesColumn& c : columns) EXPECT_EQ(c.summary.count, 1U);
    EXPECT_EQ(series.over(99.5, 99.6), plainSummary(samples, 99.5, 99.6));
    const auto at = series.valueAt(99.5004);
    EXPECT_EQ(at, samples[99'500].value);
    EXPECT_EQ(series.over(10.0, 60.0).count, 50'000U) << "older: from the buckets";
    ASSERT_TRUE(series.valueAt(5.0));
    EXPECT_NEAR(*series.valueAt(5.0), samples[5'000].value, 0.11);
}

TEST(SeriesView, inAnotherUnitIsTheViewOfConvertedSamples)
{
    SignalSeries series(0.0), converted(0.0);
    for (const PlainSample& s : wave(1000, 0.001)) {
        series.add(s.time, s.value);
        converted.add(s.time, 4.0 * s.value);
    }
    const auto view = [](const SignalSeries& from) {
        return viewOf(from, 0.2, 0.7, 50, 0.4, from.resolutionFrom(0.2));
    };
    const SeriesView shown = times(view(series), 4.0), wanted = view(converted);
    EXPECT_EQ(shown.columns, wanted.columns);
    EXPECT_EQ(shown.visible, wanted.visible);
    EXPECT_EQ(shown.before, wanted.before);
    EXPECT_EQ(shown.atCursor, wanted.atCursor);
    EXPECT_EQ(times(SeriesView{}, 4.0).atCursor, std::nullopt);
}

TEST(SignalSeries, aStepBackInTimeKeepsTheOrder)
{
    SignalSeries series(0.0);
    series.add(2.0, 1.0);
    series.add(1.0, 5.0);
    series.add(3.0, 6.0);
    EXPECT_EQ(series.valueAt(1.5), std::nullopt);
    EXPECT_EQ(series.valueAt(2.0), 5.0);
    EXPECT_EQ(series.over(0.0, 4.0).count, 3U);
    EXPECT_TRUE(std::isinf(SignalSeries(0.0).exactFrom()));
    EXPECT_TRUE(SignalSeries(0.0).columns(columnGrid(0.0, 1.0, 10)).empty());
}

}  // namespace
}  // namespace terratact
