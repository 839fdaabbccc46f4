#include "core/eval/claims.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

namespace terratact {
namespace {

constexpr Claim kClaim{"b errs less than a", Method::Pa, Method::Pac, 4, 5};

/// Scenes of several drives with one error per method and bin. The drives differ (sd
/// `betweenRuns`), the scenes of one drive hardly differ. The errors of method Pac are larger by
/// `change`.
struct ClaimWorld {
    std::vector<Scene> scenes;
    std::vector<BinError> errors;

    ClaimWorld(int runs, int scenesPerRun, double change, double betweenRuns)
    {
        std::mt19937_64 rng(11);
        const auto uniform = [&rng] { return static_cast<double>(rng() >> 11U) * 0x1p-53; };
        for (int r = 0; r < runs; ++r) {
            const double ofRun = 0.1 + betweenRuns * uniform();
            const double gain = change + betweenRuns * (uniform() - 0.5);
            for (int k = 0; k < scenesPerRun; ++k) {
                for (int bin = 4; bin <= 5; ++bin) {
                    add(Method::Pa, bin, ofRun + 0.001 * uniform());
                    add(Method::Pac, bin, -(ofRun + gain + 0.001 * uniform()));
                }
                scenes.emplace_back().run = "run" + std::to_string(r);
            }
        }
    }
    void add(Method method, int bin, double error)
    {
        errors.push_back({.scene = scenes.size(),
                          .label = std::string(name(method)),
                          .bin = bin,
                          .error = error});
    }
    ClaimResult judged(std::uint64_t seed = 1) const { return judge(kClaim, errors, scenes, seed); }
};

TEST(Claims, areThoseOfThePaper)
{
    ASSERT_EQ(kClaims.size(), 3U);
    EXPECT_EQ(binCentre(kClaims[0].firstBin), -0.3);
    EXPECT_EQ(binCentre(kClaims[0].lastBin), 0.2);
    EXPECT_EQ(binCentre(kClaims[1].firstBin), 0.3);
    EXPECT_EQ(binCentre(kClaims[1].lastBin), 0.5);
    EXPECT_EQ(binCentre(kClaims[2].firstBin), 0.6);
    EXPECT_EQ(binCentre(kClaims[2].lastBin), 0.7);
}

TEST(Judge, findsGainLossAndNoDifference)
{
    EXPECT_EQ(ClaimWorld(20, 10, -0.05, 0.02).judged().verdict, ClaimVerdict::Holds);
    EXPECT_EQ(ClaimWorld(20, 10, +0.05, 0.02).judged().verdict, ClaimVerdict::DoesNotHold);
    EXPECT_EQ(ClaimWorld(20, 10, 0.0, 0.02).judged().verdict, ClaimVerdict::NotDecided);
}

TEST(Judge, reportsMediansAndAnIntervalAroundTheirDifference)
{
    const ClaimResult r = ClaimWorld(20, 10, -0.05, 0.02).judged();
    EXPECT_EQ(r.n, 400U);
    EXPECT_EQ(r.runs, 20U);
    EXPECT_NEAR(r.baseMedian, 0.11, 0.01);
    EXPECT_NEAR(r.betterMedian, 0.06, 0.01);
    EXPECT_LT(r.low, r.betterMedian - r.baseMedian);
    EXPECT_GT(r.high, r.betterMedian - r.baseMedian);
    EXPECT_LT(r.high - r.low, 0.03);
}

TEST(Judge, countsDrivesNotScenes)
{
    // More scenes of the same drives add no information: the interval keeps its width.
    const ClaimResult few = ClaimWorld(8, 5, -0.01, 0.05).judged();
    const ClaimResult many = ClaimWorld(8, 100, -0.01, 0.05).judged();
    EXPECT_GT(many.high - many.low, 0.3 * (few.high - few.low));
    EXPECT_GT(many.high - many.low, 0.01);
}

TEST(Judge, decidesNothingFromFewerThanFiveDrives)
{
    const ClaimResult four = ClaimWorld(4, 50, -0.05, 0.001).judged();
    EXPECT_EQ(four.verdict, ClaimVerdict::NotDecided);
    EXPECT_NEAR(four.betterMedian - four.baseMedian, -0.05, 0.01);
    EXPECT_EQ(four.low, 0.0);
    EXPECT_EQ(ClaimWorld(5, 50, -0.05, 0.001).judged().verdict, ClaimVerdict::Holds);
}

TEST(Judge, comparesOnlyBinsThatBothMethodsEstimated)
{
    ClaimWorld world(6, 4, 0.0, 0.0);
    const ClaimResult before = world.judged();
    Scene alone;
    alone.run = "run0";
    world.add(Method::Pa, 4, 9.0);  // no Pac estimate of this scene
    world.scenes.push_back(alone);
    world.errors.push_back({.scene = 0, .label = "pafc", .bin = 4, .error = 9.0});
    for (const int other : {3, 6})  // not the claim's bins
        for (const Method method : {Method::Pa, Method::Pac})
            world.errors.push_back(
                {.scene = 0, .label = std::string(name(method)), .bin = other, .error = 9.0});
    const ClaimResult after = world.judged();
    EXPECT_EQ(after.n, before.n);
    EXPECT_EQ(after.baseMedian, before.baseMedian);
    EXPECT_EQ(after.low, before.low);
}

TEST(Judge, isRepeatableByItsSeed)
{
    const ClaimWorld world(8, 5, -0.01, 0.05);
    EXPECT_EQ(world.judged(3).low, world.judged(3).low);
    EXPECT_NE(world.judged(3).low, world.judged(4).low);
}

TEST(Judge, usesTheMiddleOfTwoWhenTheNumberIsEven)
{
    ClaimWorld world(1, 1, 0.0, 0.0);
    world.errors = {{.scene = 0, .label = "pa", .bin = 4, .error = -0.01},
                    {.scene = 0, .label = "pa", .bin = 5, .error = 0.05},
                    {.scene = 0, .label = "pac", .bin = 4, .error = 0.02},
                    {.scene = 0, .label = "pac", .bin = 5, .error = -0.02}};
    EXPECT_DOUBLE_EQ(world.judged().baseMedian, 0.03);
    EXPECT_DOUBLE_EQ(world.judged().betterMedian, 0.02);
}

TEST(Judge, decidesNothingWithoutErrorsAndRefusesOtherScenes)
{
    ClaimWorld world(6, 2, 0.0, 0.0);
    EXPECT_EQ(judge(kClaims[2], world.errors, world.scenes, 1).n, 0U);
    EXPECT_EQ(judge(kClaims[2], world.errors, world.scenes, 1).verdict, ClaimVerdict::NotDecided);
    EXPECT_THROW(judge(kClaim, world.errors, {}, 1), std::invalid_argument);
    EXPECT_THROW(judge(kClaims[2], world.errors, world.scenes, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
