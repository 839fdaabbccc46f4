#include "app/modelling/evaluation/tradeoff_measurement.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/learn/data/scene_file.h"
#include "tests/support/absolem.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

TEST(TradeoffMeasurement, takesScenesThatLackNothing)
{
    const TemporaryDirectory directory;
    std::vector<Scene> scenes = someScenes(1, 3);
    ASSERT_GE(scenes.size(), 3U);
    scenes.resize(3);
    scenes[0].truth[4].reset();
    scenes[1].s.frontCurrent.reset();
    const std::string path = directory.write("scenes.csv", scenesText(scenes));
    const auto whole = tradeoffScenes(path);
    ASSERT_TRUE(whole) << whole.error().text;
    ASSERT_EQ(whole->size(), 1U);
    EXPECT_EQ(whole->front().time, scenes[2].time);

    scenes.pop_back();
    const std::string lacking = directory.write("lacking.csv", scenesText(scenes));
    EXPECT_TRUE(refused(tradeoffScenes(lacking), lacking, {"every feature", "every height"}));
}

TEST(TradeoffMeasurement, measuresEverySettingOnEveryScene)
{
    const auto bundle =
        openEstimatorBundle(absolem(), TERRATACT_SOURCE_DIR "/resources/models/default.ttm", {});
    ASSERT_TRUE(bundle) << bundle.error().text;
    std::vector<Scene> scenes = someScenes(1, 3);
    scenes.resize(2);
    const MethodTradeoff measured = measureTradeoff(Method::Local, scenes, **bundle, 160, 1);
    const auto settings = tradeSettings(Method::Local, 1);
    ASSERT_EQ(measured.points.size(), settings.size());
    EXPECT_EQ(measured.reference.method, Method::Local);
    EXPECT_EQ(measured.reference.scenes, 2);
    for (std::size_t k = 0; k < settings.size(); ++k) {
        const TradePoint& point = measured.points[k];
        EXPECT_EQ(point.setting.varied, settings[k].varied);
        EXPECT_EQ(point.setting.settings, settings[k].settings);
        EXPECT_EQ(point.converged, 1.0) << "a closed form has no chains";
        EXPECT_GT(point.draws, 0);
        EXPECT_GT(point.error, 0.0);
        EXPECT_GT(point.crps, 0.0);
        EXPECT_GE(point.seconds, 0.0);
        if (point.setting.varied == "draws") {
            EXPECT_LT(point.reference.mean, 1e-6);
        }
    }
}

TEST(TradeoffMeasurement, withoutAnEstimateThereIsNoPoint)
{
    const auto bundle =
        openEstimatorBundle(absolem(), TERRATACT_SOURCE_DIR "/resources/models/default.ttm", {});
    ASSERT_TRUE(bundle) << bundle.error().text;
    const MethodTradeoff measured = measureTradeoff(Method::Local, {}, **bundle, 160, 1);
    EXPECT_TRUE(measured.points.empty());
    EXPECT_EQ(measured.reference.scenes, 0);
}

/// Returns a sampled method whose longest setting has 1000 draws.
MethodTradeoff sampledTradeoff(int referenceDraws, double rhat)
{
    MethodTradeoff measured;
    measured.points.resize(1);
    measured.points[0].draws = 1000;
    measured.reference = {.method = Method::Pafc,
                          .scenes = 1,
                          .draws = referenceDraws,
                          .rhat = rhat,
                          .ess = 900.0,
                          .error = 0.00125};
    return measured;
}

TEST(TradeoffMeasurement, theReferenceTextWarnsOfShortRuns)
{
    const std::string good = referenceText(sampledTradeoff(4000, 1.0));
    EXPECT_TRUE(good.starts_with("pafc       4000 draws, worst R-hat ")) << good;
    EXPECT_EQ(good.find("WARNING"), std::string::npos) << good;
    const std::string brief = referenceText(sampledTradeoff(3999, 1.0));
    EXPECT_NE(brief.find("WARNING: fewer than 4000 draws"), std::string::npos) << brief;
    const std::string unmixed = referenceText(sampledTradeoff(4000, 1.2));
    EXPECT_NE(unmixed.find("WARNING: R-hat above"), std::string::npos) << unmixed;
    EXPECT_EQ(unmixed.find("fewer than"), std::string::npos) << unmixed;
    MethodTradeoff closed = sampledTradeoff(1, 1.2);
    closed.reference.method = Method::Local;
    EXPECT_EQ(referenceText(closed), "");
}

}  // namespace
}  // namespace terratact
