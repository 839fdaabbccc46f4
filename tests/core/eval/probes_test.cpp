#include "core/eval/probes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

/// The truth of bin i is i cm; that of the bins ahead is 0.5 m.
Scene someScene()
{
    Scene scene;
    for (std::size_t i = 0; i < kBins; ++i) scene.truth[i] = 0.01 * static_cast<double>(i);
    scene.truth[9] = scene.truth[10] = 0.5;
    return scene;
}

/// Estimate that knows bins 0 … 8, expects 0.1 m ahead with an sd of 0.2 m, and adopts every
/// reading.
TerrainEstimate toyEstimate(const Scene& scene, std::span<const ArmReading> readings)
{
    TerrainEstimate e;
    for (std::size_t i = 0; i < kBins; ++i) {
        e.height[i] = i < 9 ? *scene.truth[i] : 0.1;
        e.sd[i] = i < 9 ? 0.01 : 0.2;
    }
    for (const ArmReading& r : readings) {
        e.height[static_cast<std::size_t>(r.bin)] = r.height;
        e.sd[static_cast<std::size_t>(r.bin)] = r.sd;
    }
    return e;
}

std::optional<int> widest(const TerrainEstimate& e, std::span<const ArmReading>)
{
    return e.sd[9] >= e.sd[10] ? 9 : 10;
}

ProbeTrial tried(const ProbeRule& rule, const ProbeLimits& limits = {})
{
    const Scene scene = someScene();
    return tryProbes(0, scene, toyEstimate(scene, {}), toyEstimate, rule, limits);
}

TEST(TryProbes, touchesUntilEverySdIsBelowTheLimit)
{
    const ProbeTrial t = tried(widest, {.armSd = 1e-6});
    EXPECT_EQ(t.probes, 2);
    EXPECT_TRUE(t.settled);
    EXPECT_NEAR(t.before.ahead, 0.4, 1e-12);
    EXPECT_NEAR(t.before.all, 0.8 / 11.0, 1e-12);
    EXPECT_NEAR(t.after.ahead, 0.2, 1e-5);  // after the first
    EXPECT_NEAR(t.after.all, 0.4 / 11.0, 1e-5);
}

TEST(TryProbes, stopsAtTheLimitOrWithoutANewBin)
{
    const ProbeTrial one = tried(widest, {.most = 1});
    EXPECT_EQ(one.probes, 1);
    EXPECT_FALSE(one.settled);
    const ProbeTrial none = tried([](const auto&, auto) { return std::optional<int>(); });
    EXPECT_EQ(none.probes, 0);
    EXPECT_FALSE(none.settled);
    EXPECT_EQ(none.before, none.after);
    EXPECT_EQ(tried([](const auto&, auto) { return std::optional(9); }).probes, 1);
    EXPECT_EQ(tried(widest, {.sdLimit = 0.3}).probes, 0);
    EXPECT_TRUE(tried(widest, {.sdLimit = 0.3}).settled);
}

TEST(TryProbes, handsTheRuleAndTheEstimatorAllReadings)
{
    std::vector<std::size_t> seen;
    const ProbeTrial t = tried([&](const TerrainEstimate& e, std::span<const ArmReading> read) {
        seen.push_back(read.size());
        return widest(e, read);
    });
    EXPECT_EQ(t.probes, 2);
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1}));
}

TEST(TryProbes, readsTheSameNoiseForTheSameSceneAndBin)
{
    const auto first9 = tried([](const auto&, auto) { return std::optional(9); });
    EXPECT_EQ(first9.after, tried([](const auto&, auto) { return std::optional(9); }).after);
    const Scene scene = someScene();
    double squares = 0.0;
    for (std::size_t k = 0; k < 2000; ++k) {
        const auto t = tryProbes(k, scene, toyEstimate(scene, {}), toyEstimate, widest,
                                 {.armSd = 0.03, .most = 1});
        squares += std::pow(2.0 * t.after.ahead - 0.4, 2) / 2000.0;  // bin 10 has an error of 0.4 m
    }
    EXPECT_NEAR(std::sqrt(squares), 0.03, 0.002);
}

TEST(TryProbes, needsTheTruthAheadAndSaneLimits)
{
    Scene scene = someScene();
    const TerrainEstimate first = toyEstimate(scene, {});
    EXPECT_TRUE(hasTruthAhead(scene));
    EXPECT_THROW((void)tryProbes(0, scene, first, toyEstimate, widest, {.armSd = 0.0}),
                 std::invalid_argument);
    EXPECT_THROW((void)tryProbes(0, scene, first, toyEstimate, widest, {.most = 0}),
                 std::invalid_argument);
    scene.truth[9].reset();
    EXPECT_FALSE(hasTruthAhead(scene));
    EXPECT_THROW((void)tryProbes(0, scene, first, toyEstimate, widest, {}), std::invalid_argument);
}

TEST(SummariseProbes, countsAnUnsettledSceneAsTheLimit)
{
    const std::vector<ProbeTrial> trials{
        {.before = {0.4, 0.2}, .after = {0.2, 0.1}, .probes = 2, .settled = true},
        {.before = {0.1, 0.1}, .after = {0.1, 0.1}, .probes = 0, .settled = true},
        {.before = {0.4, 0.3}, .after = {0.3, 0.1}, .probes = 1, .settled = false},
        {.before = {0.1, 0.2}, .after = {0.1, 0.2}, .probes = 0, .settled = false}};
    const ProbeSummary s = summariseProbes("pafc", "sd", trials, {});
    EXPECT_EQ(s.label, "pafc");
    EXPECT_EQ(s.rule, "sd");
    EXPECT_EQ(s.scenes, 4U);
    EXPECT_EQ(s.probed, 2U);
    EXPECT_EQ(s.settled, 2U);
    EXPECT_DOUBLE_EQ(s.probesNeeded, (2 + 0 + 4 + 4) / 4.0);
    EXPECT_NEAR(s.before.ahead, 0.25, 1e-12);
    EXPECT_NEAR(s.after.ahead, 0.175, 1e-12);
    EXPECT_NEAR(s.afterProbed.ahead, 0.25, 1e-12);
    EXPECT_NEAR(s.beforeProbed.all, 0.25, 1e-12);
    EXPECT_EQ(summariseProbes("pafc", "sd", {}, {}).scenes, 0U);
}

}  // namespace
}  // namespace terratact
