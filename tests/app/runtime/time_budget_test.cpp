#include "app/runtime/time_budget.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace terratact {
namespace {

using namespace std::chrono_literals;

TEST(TimeBudget, beginsWhenItIsFirstAsked)
{
    const Watch watch = endingAfter(0.2);
    std::this_thread::sleep_for(250ms);  // one-time preparation of a model
    EXPECT_FALSE(watch.outOfTime());
    std::this_thread::sleep_for(250ms);
    EXPECT_TRUE(watch.outOfTime());
}

TEST(TimeBudget, isSharedByCopiesOfTheWatch)
{
    const Watch watch = endingAfter(0.2);
    const Watch copy = watch;
    EXPECT_FALSE(watch.outOfTime());
    std::this_thread::sleep_for(250ms);
    EXPECT_TRUE(copy.outOfTime());
}

TEST(TimeBudget, ofZeroSecondsIsNone)
{
    EXPECT_FALSE(endingAfter(0.0).outOfTime);
}

}  // namespace
}  // namespace terratact
