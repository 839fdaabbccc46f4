#include "core/strip/strip_match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace terratact {
namespace {

constexpr PoseCovariance kPrior{0.03 * 0.03, 0.0, 0.05 * 0.05};

MatchedBin seen(double slope, const Vec2& e, double sd = 0.01)
{
    return {e.z - slope * e.x, slope, sd * sd};
}

TEST(StripMatch, findsTheErrorOfTheWay)
{
    const Vec2 e{0.02, -0.03};
    std::vector<MatchedBin> bins;
    for (const double slope : {-1.0, -0.5, 0.0, 0.5, 1.0, 1.0, -1.0, 0.0})
        bins.push_back(seen(slope, e, 0.001));
    const PoseOffset offset = matched(kPrior, bins);
    EXPECT_NEAR(offset.mean.x, e.x, 2e-4);
    EXPECT_NEAR(offset.mean.z, e.z, 2e-4);
    EXPECT_LT(std::sqrt(offset.covariance.xx), 0.001);
}

TEST(StripMatch, levelGroundCorrectsOnlyTheHeight)
{
    const std::vector<MatchedBin> bins(8, seen(0.0, {0.02, -0.03}));
    const PoseOffset offset = matched(kPrior, bins);
    EXPECT_NEAR(offset.mean.x, 0.0, 1e-12);
    EXPECT_NEAR(offset.mean.z, -0.03, 0.001);
    EXPECT_NEAR(offset.covariance.xx, kPrior.xx, 1e-6) << "slip is as unknown as before";
    EXPECT_LT(offset.covariance.zz, 0.1 * kPrior.zz);
}

TEST(StripMatch, nothingSharedLeavesThePrior)
{
    const PoseOffset offset = matched(kPrior, {});
    EXPECT_EQ(offset.mean, Vec2{});
    EXPECT_NEAR(offset.covariance.zz, kPrior.zz, 1e-6);
}

TEST(StripMatch, oneWrongBinDoesNotMoveTheWay)
{
    std::vector<MatchedBin> bins(7, seen(0.0, {0.0, 0.01}));
    bins.push_back(seen(0.0, {0.0, 0.4}));
    EXPECT_NEAR(matched(kPrior, bins).mean.z, 0.01, 0.004);
}

TEST(StripMatch, aRobotThatStoodStillStays)
{
    const std::vector<MatchedBin> bins(8, seen(0.5, {0.0, 0.02}));
    const PoseOffset offset = matched({}, bins);
    EXPECT_NEAR(offset.mean.z, 0.0, 2e-5);
    EXPECT_TRUE(std::isfinite(offset.covariance.xx));
}

TEST(PoseCovariance, slipAlongTheSlopeHardlyCounts)
{
    const PoseCovariance along = covarianceOf({.slipForward = 0.04, .slipUp = 0.02});
    EXPECT_NEAR(heightSd(along, {0.5, 0.5}), 0.0, 1e-12);
    EXPECT_NEAR(heightSd(along, {0.5, -0.5}), 0.04, 1e-12);
    EXPECT_EQ(heightSd(along - along, {0.5, -0.5}), 0.0);
}

}  // namespace
}  // namespace terratact
