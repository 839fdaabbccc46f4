#include "core/learn/data/bin_set.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(BinSet, readsRangesAndLists)
{
    EXPECT_EQ(binsOf(*binSetFrom("0-3")), (std::vector{0, 1, 2, 3}));
    EXPECT_EQ(binsOf(*binSetFrom("0,4,10")), (std::vector{0, 4, 10}));
    EXPECT_EQ(binsOf(*binSetFrom("9-10,0-1,5")), (std::vector{0, 1, 5, 9, 10}));
    EXPECT_EQ(binSetFrom("0-10"), kAllBins);
}

TEST(BinSet, everySetSurvivesARoundTripAsText)
{
    for (unsigned long mask = 1; mask < 1UL << kBins; ++mask) {
        const BinSet bins(mask);
        ASSERT_EQ(binSetFrom(text(bins)), bins) << text(bins);
    }
    EXPECT_EQ(text(BinSet("11100010001")), "0,4,8-10");
    EXPECT_EQ(text(BinSet{}), "none");
}

TEST(BinSet, refusesNoBinsAndDuplicates)
{
    for (const char* wrong :
         {"",    ",",     "0,", ",0", "-",  "0-", "-3",   "3-1", "11",          "0-11", "-1",
          "1,1", "0-4,3", "a",  "1a", "1 ", " 1", "1--2", "0x1", "99999999999", "+1"})
        EXPECT_FALSE(binSetFrom(wrong)) << '"' << wrong << '"';
}

}  // namespace
}  // namespace terratact
