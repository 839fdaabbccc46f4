// Tests the unit of times by their size and steps.
#include "core/bags/time_unit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace terratact {
namespace {

TEST(TimeUnits, everyUnitIsKnownFromTheBeginAndFromTheEpoch)
{
    for (const auto& [name, perSecond] :
         {std::pair{"s", 1.0}, {"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}})
        for (const double begin : {0.0, 12.5, 3600.0, 1e6, 1.7e9})
            for (const double rate : {2.5, 20.0, 100.0, 400.0}) {
                const TimeUnit unit = timeUnitOf(std::round(begin * perSecond), perSecond / rate);
                EXPECT_EQ(unit.name, std::string(name)) << begin << " s, " << rate << " Hz";
                EXPECT_EQ(unit.seconds, 1.0 / perSecond);
            }
}

TEST(TimeUnits, aSingleTimeIsKnownByItsSize)
{
    EXPECT_EQ(timeUnitOf(1.7e9, 0.0).name, std::string("s"));
    EXPECT_EQ(timeUnitOf(1.7e12, 0.0).name, std::string("ms"));
    EXPECT_EQ(timeUnitOf(1.7e15, 0.0).name, std::string("us"));
    EXPECT_EQ(timeUnitOf(1.7e18, 0.0).name, std::string("ns"));
    EXPECT_EQ(timeUnitOf(5.0, 0.0).name, std::string("s"));
}

TEST(TimeUnits, anHourOfNanosecondsIsNoDayInMilliseconds)
{
    EXPECT_EQ(timeUnitOf(1.7e12, 5e7).name, std::string("ns")) << "28 minutes after the start";
    EXPECT_EQ(timeUnitOf(1.7e12, 50.0).name, std::string("ms"));
    EXPECT_EQ(timeUnitOf(1.7e12, 1000.0).name, std::string("ms")) << "once in a second";
}

}  // namespace
}  // namespace terratact
