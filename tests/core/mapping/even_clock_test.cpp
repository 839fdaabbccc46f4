// Tests times of series that were recorded while the clock was set.
#include "core/mapping/even_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace terratact {
namespace {

constexpr std::int64_t kOneSecond = 1'000'000'000;

struct TimedSample {
    std::int64_t time = 0;
};

std::vector<TimedSample> timedAt(std::initializer_list<double> seconds)
{
    std::vector<TimedSample> made;
    for (const double s : seconds) made.push_back({std::llround(s * 1e9)});
    return made;
}

std::vector<double> secondsOfSamples(const std::vector<TimedSample>& samples)
{
    std::vector<double> found;
    for (const TimedSample& sample : samples)
        found.push_back(static_cast<double>(sample.time) * 1e-9);
    return found;
}

TEST(EvenClock, risingTimesStayAsTheyAre)
{
    EvenClock clock;
    auto a = timedAt({5, 5, 5.5, 900, 899.5, 901});
    clock.make(a);
    EXPECT_EQ(secondsOfSamples(a), (std::vector<double>{5, 5, 5.5, 900, 899.5, 901}));
    EXPECT_TRUE(clock.steps().empty()) << "half a second is disorder, no set clock";
}

TEST(EvenClock, timesContinueWhereTheClockWasSet)
{
    EvenClock clock;
    auto back = timedAt({5000, 5001, 1401.5, 1402.5, 4e9, 4e9 + 1});
    clock.make(back);
    EXPECT_EQ(secondsOfSamples(back), (std::vector<double>{5000, 5001, 5002, 5003, 5004, 5005}));
    ASSERT_EQ(clock.steps().size(), 2U);
    EXPECT_DOUBLE_EQ(clock.steps()[0].back, 3599.5);
    EXPECT_EQ(clock.steps()[0].time, 5002 * kOneSecond);
    EXPECT_LT(clock.steps()[1].back, -3e9);
}

TEST(EvenClock, allSeriesShareAStep)
{
    EvenClock clock;
    auto fast = timedAt({100, 100.5, 50.75, 51.25}), slow = timedAt({99, 52, 54});
    clock.make(fast);
    clock.make(slow);
    EXPECT_EQ(secondsOfSamples(fast), (std::vector<double>{100, 100.5, 101, 101.5}));
    EXPECT_EQ(secondsOfSamples(slow), (std::vector<double>{99, 102.25, 104.25}))
        << "52 s is 1.25 s behind 50.75 s in both";
    EXPECT_EQ(clock.steps().size(), 1U);
}

TEST(EvenClock, valuesWithoutAnOrderAreLeftAlone)
{
    EvenClock clock;
    std::vector<TimedSample> mixed;
    for (int i = 0; i < 40; ++i) mixed.push_back({(i % 2 == 0 ? i : i + 100) * kOneSecond});
    const auto before = secondsOfSamples(mixed);
    clock.make(mixed);
    EXPECT_EQ(secondsOfSamples(mixed), before);
    EXPECT_TRUE(clock.isDisordered());
    EXPECT_TRUE(clock.steps().empty());
}

TEST(EvenClock, columnsShareTheStepsOfTheirRows)
{
    EvenClock clock;
    std::vector<TimedSample> full, sparse;
    const auto rows = timedAt({10, 10.2, 10.4, 10.1, 10.3, 10.3005, 10.3, 10.5});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        clock.addRow(rows[i].time, [&](auto visit) {
            visit(full);
            visit(sparse);
        });
        full.push_back(rows[i]);
        if (i == 0 || i == 7) sparse.push_back(rows[i]);
    }
    clock.make(full);
    clock.make(sparse);
    const auto even = secondsOfSamples(full);
    const std::vector<double> expected{10, 10.2, 10.4, 10.6, 10.8, 10.8005, 10.8, 11};
    ASSERT_EQ(even.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(even[i], expected[i], 1e-9) << i;
    EXPECT_NEAR(secondsOfSamples(sparse)[1], 11.0, 1e-9) << "it lacks the rows around the step";
    ASSERT_EQ(clock.steps().size(), 1U) << "half a millisecond is jitter";
    EXPECT_NEAR(clock.steps()[0].back, 0.3, 1e-6);
    EXPECT_FALSE(clock.isDisordered());
}

TEST(EvenClock, aRowThatComesLateIsNoStep)
{
    EvenClock clock;
    std::vector<TimedSample> series;
    for (const TimedSample& row : timedAt({10, 10.2, 10.4, 10.15, 10.6, 10.8, 10.5})) {
        clock.addRow(row.time, [&](auto visit) { visit(series); });
        series.push_back(row);
    }
    const auto before = secondsOfSamples(series);
    clock.make(series);
    EXPECT_EQ(secondsOfSamples(series), before);
    EXPECT_TRUE(clock.steps().empty());
    EXPECT_FALSE(clock.isDisordered());
}

TEST(EvenClock, rowsWithoutAnOrderAreLeftAlone)
{
    EvenClock clock;
    std::vector<TimedSample> falling;
    for (int i = 0; i < 40; ++i) {
        clock.addRow((100 - i) * kOneSecond, [&](auto visit) { visit(falling); });
        falling.push_back({(100 - i) * kOneSecond});
    }
    const auto before = secondsOfSamples(falling);
    clock.make(falling);
    EXPECT_EQ(secondsOfSamples(falling), before);
    EXPECT_TRUE(clock.isDisordered());
    EXPECT_TRUE(clock.steps().empty());
}

TEST(EvenClock, extremeTimesDoNotOverflow)
{
    EvenClock clock;
    std::vector<TimedSample> extreme{{std::numeric_limits<std::int64_t>::max()},
                                     {std::numeric_limits<std::int64_t>::min()}};
    clock.make(extreme);
    EXPECT_EQ(clock.steps().size(), 1U);
}

TEST(ClockRemarks, countManySteps)
{
    const auto remarks = clockRemarks(std::vector<ClockStep>(9, {.back = 2.0}));
    ASSERT_EQ(remarks.size(), 6U);
    EXPECT_EQ(remarks[0], "the clock was set back by 2.000 s while this was recorded; times "
                          "continue evenly from there");
    EXPECT_EQ(remarks[5], "the clock was set 4 more times");
}

}  // namespace
}  // namespace terratact
