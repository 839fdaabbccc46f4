#include "app/modelling/tradeoff_csv.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <stdexcept>
#include <tuple>

#include "app/figures/tradeoff_figure.h"
#include "core/learn/model/model_file.h"
#include "tests/support/picture.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TradePoint point(std::string varied, std::optional<QualityPreset> preset, double seconds,
                 double off)
{
    TradePoint p;
    p.setting = {std::move(varied), Settings{.method = Method::Pafc}, preset};
    p.seconds = seconds;
    p.reference = {0.5 * off, off};
    p.error = 0.02;
    p.crps = 0.015;
    p.draws = 800;
    p.converged = 0.75;
    return p;
}

const std::vector<TradePoint> kPoints{point("fast", QualityPreset::Fast, 0.001, 0.003),
                                      point("draws", std::nullopt, 0.002, 0.004),
                                      point("accurate", QualityPreset::Accurate, 0.05, 0.0005)};

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
    EXPECT_EQ(measured.size(), kMethods.size() * kQualityPresets.size());
}

TEST(PresetsCsv, refusesWhatItIsNot)
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

// Colours and geometry of app/figures/tradeoff_figure.cpp and app/figures/method_style.cpp.
constexpr int kLeft = 96, kRight = 856, kTop = 110, kBottom = 620, kSecondLeft = 990;
constexpr unsigned kPafc = 0x12804a, kJoint = 0x0b7f8c, kLocal = 0xb01e4f;

TradePoint marker(Method method, double ms, double quantileMm, double errorMm)
{
    TradePoint p = point("draws", std::nullopt, 1e-3 * ms, 1e-3 * quantileMm);
    p.setting.settings.method = method;
    p.error = 1e-3 * errorMm;
    return p;
}

class TradeoffFigure : public testing::Test {
protected:
    Picture drawn(const std::vector<TradePoint>& points)
    {
        const std::string path = directory_.file("tradeoff.png");
        EXPECT_TRUE(writeTradeoffFigure(path, points));
        return readPng(path);
    }

    /// Returns the panel that begins at this column, without legend and other panel.
    static Picture panel(const Picture& picture, int left)
    {
        Picture part = picture;
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x)
                if (y > kBottom + 20 || x < left - 20 || x > left + kRight - kLeft + 20)
                    part.pixels[static_cast<std::size_t>(y * part.width + x)] = 0xffffffU;
        return part;
    }

    static std::array<double, 2> centre(const Picture& picture, unsigned colour)
    {
        const auto [left, right, top, bottom] = picture.extent(colour);
        EXPECT_GT(right, left);
        return {0.5 * (left + right), 0.5 * (top + bottom)};
    }

    TemporaryDirectory directory_;
};

TEST_F(TradeoffFigure, placesSettingsByLogTimeAndLogError)
{
    const Picture picture =
        drawn({marker(Method::Pafc, 1.0, 100.0, 1.0), marker(Method::Joint, 10.0, 10.0, 10.0),
               marker(Method::Local, 100.0, 1.0, 100.0)});
    EXPECT_EQ(picture.width, 1800);
    EXPECT_EQ(picture.height, 760);
    const double middle = 0.5 * (kTop + kBottom), half = 0.5 * (kRight - kLeft);
    for (const auto& [left, first, last] :
         {std::tuple(kLeft, kTop, kBottom), std::tuple(kSecondLeft, kBottom, kTop)}) {
        const Picture part = panel(picture, left);
        const auto pafc = centre(part, kPafc), joint = centre(part, kJoint),
                   local = centre(part, kLocal);
        EXPECT_NEAR(pafc[0], left, 1.5);
        EXPECT_NEAR(joint[0], left + half, 1.5);
        EXPECT_NEAR(local[0], left + 2.0 * half, 1.5);
        EXPECT_NEAR(pafc[1], first, 1.5);
        EXPECT_NEAR(joint[1], middle, 1.5);
        EXPECT_NEAR(local[1], last, 1.5);
    }
}

TEST_F(TradeoffFigure, drawsPresetsLargerThanOtherSettings)
{
    TradePoint preset = marker(Method::Joint, 10.0, 10.0, 10.0);
    const int plain = panel(drawn({preset}), kLeft).extent(kJoint)[3];
    preset.setting.preset = QualityPreset::Balanced;
    EXPECT_GE(panel(drawn({preset}), kLeft).extent(kJoint)[3], plain + 2);  // its name is above
}

TEST_F(TradeoffFigure, drawsTheParetoFrontOnly)
{
    // The front is a line through the panel's centre. There is no line if one point is dominated or belongs to another
    // method.
    const auto darkPixels = [&](double firstMm, double secondMm, Method second = Method::Pafc) {
        const Picture picture = drawn(
            {marker(Method::Pafc, 1.0, firstMm, 10.0), marker(second, 100.0, secondMm, 10.0)});
        int dark = 0;
        for (int y = (kTop + kBottom) / 2 - 10; y < (kTop + kBottom) / 2 + 10; ++y)
            for (int x = (kLeft + kRight) / 2 - 10; x < (kLeft + kRight) / 2 + 10; ++x)
                if ((picture.at(x, y) >> 16U) < 0xa0U) ++dark;
        return dark;
    };
    EXPECT_GT(darkPixels(100.0, 1.0), 10);
    EXPECT_EQ(darkPixels(1.0, 100.0), 0);
    EXPECT_EQ(darkPixels(100.0, 1.0, Method::Pa), 0);
}

TEST_F(TradeoffFigure, staysInItsFrameWhateverTheNumbers)
{
    for (const double mm : {0.0, 1e-12, 1e-3, 1.0, 9.99, 1e6}) {
        const Picture part = panel(drawn({marker(Method::Joint, mm, mm, mm)}), kLeft);
        EXPECT_GT(part.count(kJoint), 30) << mm;
        const auto [left, right, top, bottom] = part.extent(kJoint);
        EXPECT_GE(left, kLeft - 15) << mm;
        EXPECT_LE(right, kRight + 15) << mm;
        EXPECT_GE(top, kTop - 15) << mm;
        EXPECT_LE(bottom, kBottom + 15) << mm;
    }
}

TEST_F(TradeoffFigure, refusesNoPointsAndAnotherEnding)
{
    const std::string other = directory_.file("tradeoff.bmp");
    EXPECT_THROW((void)writeTradeoffFigure(other, {}), std::invalid_argument);
    EXPECT_TRUE(refused(writeTradeoffFigure(other, kPoints), other, {".png, .svg or .pdf"}));
    EXPECT_TRUE(directory_.entries().empty());
}

}  // namespace
}  // namespace terratact
