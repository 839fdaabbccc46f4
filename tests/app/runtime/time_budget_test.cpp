#include "app/runtime/time_budget.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(TimeBudget, beginsWhenItIsFirstAsked)
{
    double now = 100.0;
    const Watch watch = endingAfter(0.2, [&now] { return now; });
    now += 5.0;  // one-time preparation of a model
    EXPECT_FALSE(watch.outOfTime());
    now += 0.19;
    EXPECT_FALSE(watch.outOfTime());
    now += 0.02;
    EXPECT_TRUE(watch.outOfTime());
}

TEST(TimeBudget, isSharedByCopiesOfTheWatch)
{
    double now = 100.0;
    const Watch watch = endingAfter(0.2, [&now] { return now; });
    const Watch copy = watch;
    EXPECT_FALSE(watch.outOfTime());
    now += 0.25;
    EXPECT_TRUE(copy.outOfTime());
}

TEST(TimeBudget, followsTheSteadyClock)
{
    const Watch watch = endingAfter(1e-9);
    (void)watch.outOfTime();
    const double begun = steadyNow();
    while (steadyNow() <= begun) {
    }
    EXPECT_TRUE(watch.outOfTime());
    EXPECT_FALSE(endingAfter(1e6).outOfTime());
}

TEST(TimeBudget, ofZeroSecondsIsNone)
{
    EXPECT_FALSE(endingAfter(0.0).outOfTime);
}

}  // namespace
}  // namespace terratact
