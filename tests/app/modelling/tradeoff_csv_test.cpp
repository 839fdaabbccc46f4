//
#include "app/modelling/tradeoff_csv.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/learn/model/file/model_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/trade_point.h"

namespace terratact {
namespace {

const std::vector<TradePoint> kPoints{
    tradePoint("fast", QualityPreset::Fast, 0.001, 0.003),
    tradePoint("draws", std::nullopt, 0.002, 0.004),
    tradePoint("accurate", QualityPreset::Accurate, 0.05, 0.0005)};

TEST(TradeoffCsv, marksTheFronts)
{
    const std::string text = tradeoffCsv(kPoints);
    EXPECT_NE(text.find("pafc,fast,1000,16,50,single,all,800,0.75,1,1.5,3,20,15,1,1\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("pafc,draws,1000,16,50,single,all,800,0.75,2,2,4,20,15,0,0\n"),
              std::string::npos);
    EXPECT_NE(text.find("pafc,accurate,1000,16,50,single,all,800,0.75,50,0.25,0.5,20,15,1,0\n"),
              std::string::npos);
}

TEST(PresetsCsv, goesBackAndForth)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("presets.csv", presetsCsv("abc", kPoints));
    const auto costs = readPresets(path);
    ASSERT_TRUE(costs) << costs.error().text;
    EXPECT_EQ(costs->model, "abc");
    const std::vector<PresetCost> expected{
        {Method::Pafc, QualityPreset::Fast, 1000, 16, 50, 0, 1.0, 3.0, 20.0, 0.75},
        {Method::Pafc, QualityPreset::Accurate, 1000, 16, 50, 0, 50.0, 0.5, 20.0, 0.75}};
    EXPECT_EQ(costs->costs, expected);
}

TEST(PresetsCsv, shippedFileMatchesShippedModelAndPresets)
{
    const std::string models = TERRATACT_SOURCE_DIR "/resources/models/";
    const auto presets = readPresets(models + "default.presets.csv");
    ASSERT_TRUE(presets) << presets.error().text;
    const auto model = readModel(models + "default.ttm");
    ASSERT_TRUE(model) << model.error().text;
    EXPECT_EQ(presets->model, model->contentHash) << "measure anew: docs/tradeoff.sh";
    std::set<std::pair<Method, QualityPreset>> measured;
    for (const PresetCost& cost : presets->costs) {
        measured.insert({cost.method, cost.preset});
        const Settings s = withPreset({.method = cost.method}, cost.preset);
        const std::array now{s.draws, s.chains, s.burnIn, s.inducing};
        EXPECT_EQ((std::array{cost.draws, cost.chains, cost.burnIn, cost.inducing}), now)
            << name(cost.method) << ' ' << name(cost.preset) << ": measure anew: docs/tradeoff.sh";
    }
    EXPECT_EQ(measured.size(), kSceneMethods.size() * kQualityPresets.size());
}

TEST(PresetsCsv, refusesOtherFiles)
{
    const TemporaryDirectory directory;
    const std::string header = "model,method,quality,draws,chains,burn_in,inducing,ms,quantile_off_"
                               "mm,error_mm,converged\n";
    const std::string rest = ",8,4,2,0,1,2,3,1\n";
    const auto refuses = [&](const std::string& text,
                             std::initializer_list<std::string_view> parts) {
        const std::string path = directory.write("presets.csv", text);
        return refused(readPresets(path), path, parts);
    };
    EXPECT_TRUE(refuses("a,b\n", {"line 1", "header"}));
    EXPECT_TRUE(refuses(header + "abc,local,best" + rest, {"line 2", "quality"}));
    EXPECT_TRUE(refuses(header + "abc,best,fast" + rest, {"line 2", "method"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,x,2,0,1,2,3,1\n", {"line 2", "field 5"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,4,-2,0,1,2,3,1\n", {"line 2", "no count"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,4,2.5,0,1,2,3,1\n", {"line 2", "no count"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,4,2,0,-1,2,3,1\n", {"line 2", "below 0"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,4,2,0,1,2,3,7\n", {"line 2", "share"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast,8,4,2,0,1,2,3\n", {"line 2", "eleven"}));
    EXPECT_TRUE(refuses(header + "abc,local,fast" + rest + "abd,joint,fast" + rest,
                        {"line 3", "another model"}));
}

}  // namespace
}  // namespace terratact
