#include "core/infer/estimate/felt_horizon.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TerrainEstimate touchedAt(std::initializer_list<std::size_t> bins, Touch elsewhere)
{
    TerrainEstimate e;
    e.touch.fill(elsewhere);
    for (const std::size_t bin : bins) e.touch[bin] = Touch::Felt;
    return e;
}

TEST(FeltHorizon, endsAtTheFirstBinThatIsNotFelt)
{
    for (const Touch other : {Touch::Bounded, Touch::FeltInPart, Touch::NotFelt}) {
        TerrainEstimate e = touchedAt({5, 6, 8}, other);
        e.feltTo = binEnd(9);
        EXPECT_EQ(horizonBin(e), 9);
        EXPECT_EQ(lastFeltBin(e), 6);
        EXPECT_EQ(feltHorizon(e), binEnd(6));
        e.touch[7] = Touch::Remembered;
        EXPECT_EQ(feltHorizon(e), binEnd(8));
    }
}

TEST(FeltHorizon, isEmptyWhereTheFirstBinAheadIsNotFelt)
{
    TerrainEstimate e = touchedAt({3, 4, 7}, Touch::Bounded);
    e.feltTo = binEnd(7);
    EXPECT_EQ(horizonBin(e), 7);
    EXPECT_EQ(lastFeltBin(e), kFirstAhead - 1);
    EXPECT_EQ(feltHorizon(e), std::nullopt);
}

TEST(FeltHorizon, isEmptyWhereTheTouchIsNotRecorded)
{
    TerrainEstimate e = touchedAt({5, 6}, Touch::Bounded);
    e.touch[7] = Touch::Unrecorded;
    EXPECT_EQ(lastFeltBin(e), kBins - 1);
    EXPECT_EQ(feltHorizon(e), std::nullopt);
}

}  // namespace
}  // namespace terratact
