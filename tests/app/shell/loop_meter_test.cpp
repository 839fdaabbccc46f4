// Tests the lateness of the event loop.
#include "app/shell/loop_meter.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(NewestValues, quantilesAreOfTheNewest)
{
    NewestValues values(100);
    EXPECT_EQ(values.quantile(0.99), 0.0);
    for (int i = 1; i <= 250; ++i) values.add(i);
    EXPECT_EQ(values.count(), 100U);
    EXPECT_EQ(values.quantile(0.0), 151.0);
    EXPECT_EQ(values.quantile(0.5), 200.0);
    EXPECT_EQ(values.quantile(0.99), 249.0);
    EXPECT_EQ(values.most(), 250.0);
    EXPECT_THROW((void)values.quantile(1.1), std::invalid_argument);
}

TEST(LoopMeter, countsWhatABeatIsLate)
{
    LoopMeter meter(0.01);
    for (const double beat : {5.0, 5.01, 5.05, 5.055}) meter.beat(beat);
    EXPECT_EQ(meter.lateness().count(), 3U);
    EXPECT_NEAR(meter.lateness().most(), 0.03, 1e-9);
    EXPECT_NEAR(meter.lateness().quantile(0.0), 0.0, 1e-9) << "early is not late";
    meter.frame(0.004, 0.02);
    meter.frame(0.005, -1.0);
    EXPECT_EQ(meter.frames().count(), 2U);
    EXPECT_EQ(meter.latencies().count(), 1U);
    EXPECT_THROW(LoopMeter(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
