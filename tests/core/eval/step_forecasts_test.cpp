#include "core/eval/step_forecasts.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace terratact {
namespace {

/// Level ground with a step of 0.2 m up from bin `at` on; no step for kBins.
Heights stepAt(int at)
{
    Heights h{};
    for (int i = at; i < kBins; ++i) h[static_cast<std::size_t>(i)] = 0.2;
    return h;
}

Scene sceneOf(const Heights& truth)
{
    Scene scene;
    for (std::size_t i = 0; i < kBins; ++i) scene.truth[i] = truth[i];
    return scene;
}

TEST(StepForecasts, coverAllBinsAndBinsAheadSeparately)
{
    TerrainEstimate e;
    e.draws = {stepAt(2), stepAt(6), stepAt(7), stepAt(kBins)};
    const auto behind = stepForecasts(3, sceneOf(stepAt(6)), "pa", e, 0.1);
    ASSERT_EQ(behind.size(), 2U);
    EXPECT_EQ(behind[0].scene, 3U);
    EXPECT_EQ(behind[0].label, "pa");
    EXPECT_EQ(behind[0].place, StepPlace::Anywhere);
    EXPECT_DOUBLE_EQ(behind[0].probability, 0.75);
    EXPECT_TRUE(behind[0].observed);
    EXPECT_EQ(behind[1].place, StepPlace::Ahead);
    EXPECT_DOUBLE_EQ(behind[1].probability, 0.25);  // only the step up to +0.4 is ahead
    EXPECT_FALSE(behind[1].observed);
    EXPECT_TRUE(stepForecasts(0, sceneOf(stepAt(7)), "pa", e, 0.1)[1].observed);
    EXPECT_FALSE(stepForecasts(0, sceneOf(stepAt(7)), "pa", e, 0.25)[0].observed);
}

TEST(StepForecasts, needTheTruthOfTheirBinsAndDraws)
{
    TerrainEstimate e;
    Scene scene = sceneOf(stepAt(7));
    EXPECT_TRUE(stepForecasts(0, scene, "pa", e, 0.1).empty());
    e.draws = {stepAt(2)};
    scene.truth[0].reset();
    const auto ahead = stepForecasts(0, scene, "pa", e, 0.1);
    ASSERT_EQ(ahead.size(), 1U);
    EXPECT_EQ(ahead[0].place, StepPlace::Ahead);
}

/// Forecasts of one place, scene k of drive k.
struct ForecastWorld {
    std::vector<StepForecast> forecasts;
    std::vector<Scene> scenes;

    void add(double p, bool observed)
    {
        forecasts.push_back({scenes.size(), "pa", StepPlace::Ahead, p, observed});
        scenes.emplace_back().run = std::to_string(scenes.size());
    }
};

TEST(BrierSummaries, decomposeTheScore)
{
    ForecastWorld world;  // by hand: score 0.1525
    world.add(0.1, false);
    world.add(0.1, false);
    world.add(0.1, true);
    world.add(0.1, false);
    world.add(0.8, true);
    world.add(0.8, true);
    world.add(0.8, false);
    world.add(0.8, true);
    const auto summaries = brierSummaries(world.forecasts, world.scenes, 1);
    ASSERT_EQ(summaries.size(), 1U);
    const BrierSummary& b = summaries[0];
    EXPECT_EQ(b.n, 8U);
    EXPECT_DOUBLE_EQ(b.observedShare, 0.5);
    EXPECT_NEAR(b.score, (3 * 0.01 + 0.81 + 3 * 0.04 + 0.64) / 8.0, 1e-12);
    EXPECT_NEAR(b.reliability, 0.5 * (0.15 * 0.15 + 0.05 * 0.05), 1e-12);
    EXPECT_NEAR(b.resolution, 0.0625, 1e-12);
    EXPECT_DOUBLE_EQ(b.uncertainty, 0.25);
    EXPECT_NEAR(b.score, b.reliability - b.resolution + b.uncertainty, 1e-12);
    EXPECT_EQ(b.classes[0].n, 4U);  // 0.1 closes the first class
    EXPECT_DOUBLE_EQ(b.classes[0].observedShare, 0.25);
    EXPECT_EQ(b.classes[7].n, 4U);
    EXPECT_NEAR(b.classes[7].meanForecast, 0.8, 1e-12);
    ASSERT_TRUE(b.interval);
    EXPECT_LT(b.interval->low, b.score);
    EXPECT_GT(b.interval->high, b.score);
}

TEST(BrierSummaries, certainForecastsFallIntoTheOuterClasses)
{
    ForecastWorld world;
    world.add(0.0, false);
    world.add(1.0, true);
    const auto summaries = brierSummaries(world.forecasts, world.scenes, 1);
    EXPECT_EQ(summaries[0].classes.front().n, 1U);
    EXPECT_EQ(summaries[0].classes.back().n, 1U);
    EXPECT_EQ(summaries[0].score, 0.0);
    EXPECT_FALSE(summaries[0].interval);
    EXPECT_TRUE(brierSummaries({}, {}, 1).empty());
    EXPECT_THROW(brierSummaries(world.forecasts, {}, 1), std::invalid_argument);
}

TEST(BrierSummaries, separateLabelsAndPlaces)
{
    ForecastWorld world;
    world.add(0.5, true);
    world.add(0.5, true);
    world.forecasts[1].label = "flat";
    world.add(0.5, true);
    world.forecasts[2].place = StepPlace::Anywhere;
    EXPECT_EQ(brierSummaries(world.forecasts, world.scenes, 1).size(), 3U);
}

}  // namespace
}  // namespace terratact
