// Tests the error of an estimate against true heights.
#include "core/eval/estimate_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terratact {
namespace {

TEST(EstimateError, hasTheRootMeanSquareAndTheWorstBin)
{
    TerrainEstimate estimate;
    estimate.q10.fill(-0.05);
    estimate.q90.fill(0.05);
    Heights truth{};
    EXPECT_EQ(errorAgainst(estimate, truth), (EstimateError{0.0, 0.0, 0, kBins}));
    truth[3] = 0.04;
    truth[7] = -0.3;
    const EstimateError error = errorAgainst(estimate, truth);
    EXPECT_NEAR(error.rms, std::sqrt((0.04 * 0.04 + 0.3 * 0.3) / 11.0), 1e-12);
    EXPECT_DOUBLE_EQ(error.largest, 0.3);
    EXPECT_EQ(error.bin, 7);
    EXPECT_EQ(error.inBand, kBins - 1);
}

}  // namespace
}  // namespace terratact
