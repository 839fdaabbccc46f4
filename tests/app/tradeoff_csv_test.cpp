#include "app/tradeoff_csv.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TradePoint point(std::string varied, std::optional<Quality> preset, double seconds, double off)
{
    TradePoint p;
    p.setting = {std::move(varied), Settings{}, preset};
    p.seconds = seconds;
    p.reference = {0.5 * off, off};
    p.error = 0.02;
    p.crps = 0.015;
    return p;
}

const std::vector<TradePoint> kPoints{point("fast", Quality::Fast, 0.001, 0.003),
                                      point("draws", std::nullopt, 0.002, 0.004),
                                      point("accurate", Quality::Accurate, 0.05, 0.0005)};

TEST(TradeoffCsv, marksTheFronts)
{
    const std::string text = tradeoffCsv(kPoints);
    EXPECT_NE(text.find("local,fast,1000,16,50,single,all,1,1.5,3,20,15,1,1\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("local,draws,1000,16,50,single,all,2,2,4,20,15,0,0\n"), std::string::npos);
    EXPECT_NE(text.find("local,accurate,1000,16,50,single,all,50,0.25,0.5,20,15,1,0\n"),
              std::string::npos);
}

TEST(PresetsCsv, goesBackAndForth)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("presets.csv", presetsCsv(kPoints));
    const auto costs = readPresets(path);
    ASSERT_TRUE(costs) << costs.error().text;
    const std::vector<PresetCost> expected{{Method::Local, Quality::Fast, 1.0, 3.0, 20.0},
                                           {Method::Local, Quality::Accurate, 50.0, 0.5, 20.0}};
    EXPECT_EQ(*costs, expected);
}

TEST(PresetsCsv, refusesWhatItIsNot)
{
    const TemporaryDirectory directory;
    const std::string header = "method,quality,ms,quantile_off_mm,error_mm\n";
    const auto refuses = [&](const std::string& text,
                             std::initializer_list<std::string_view> parts) {
        const std::string path = directory.write("presets.csv", text);
        return refused(readPresets(path), path, parts);
    };
    EXPECT_TRUE(refuses("a,b\n", {"line 1", "header"}));
    EXPECT_TRUE(refuses(header + "local,best,1,2,3\n", {"line 2", "quality"}));
    EXPECT_TRUE(refuses(header + "best,fast,1,2,3\n", {"line 2", "method"}));
    EXPECT_TRUE(refuses(header + "local,fast,1,x,3\n", {"line 2", "field 4"}));
}

}  // namespace
}  // namespace terratact
