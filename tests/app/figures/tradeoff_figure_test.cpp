// Tests the figure of time against accuracy.
#include "app/figures/tradeoff_figure.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <tuple>

#include "tests/support/picture.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/trade_point.h"

namespace terratact {
namespace {

// Colours and geometry of app/figures/tradeoff_figure.cpp and app/figures/method_style.cpp.
constexpr int kFrameLeft = 96, kFrameRight = 856, kFrameTop = 110, kFrameBottom = 620,
              kSecondLeft = 990;
constexpr unsigned kPafcColour = 0x12804a, kJointColour = 0x0b7f8c, kLocalColour = 0xb01e4f;

TradePoint marker(Method method, double ms, double quantileMm, double errorMm)
{
    TradePoint p = tradePoint("draws", std::nullopt, 1e-3 * ms, 1e-3 * quantileMm);
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
                if (y > kFrameBottom + 20 || x < left - 20
                    || x > left + kFrameRight - kFrameLeft + 20)
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
    const double middle = 0.5 * (kFrameTop + kFrameBottom), half = 0.5 * (kFrameRight - kFrameLeft);
    for (const auto& [left, first, last] : {std::tuple(kFrameLeft, kFrameTop, kFrameBottom),
                                            std::tuple(kSecondLeft, kFrameBottom, kFrameTop)}) {
        const Picture part = panel(picture, left);
        const auto pafc = centre(part, kPafcColour), joint = centre(part, kJointColour),
                   local = centre(part, kLocalColour);
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
    const int plain = panel(drawn({preset}), kFrameLeft).extent(kJointColour)[3];
    preset.setting.preset = QualityPreset::Balanced;
    EXPECT_GE(panel(drawn({preset}), kFrameLeft).extent(kJointColour)[3],
              plain + 2);  // its name is above
}

TEST_F(TradeoffFigure, drawsTheParetoFrontOnly)
{
    // The front is a line through the panel's centre. There is no line if one point is dominated or belongs to another
    // method.
    const auto darkPixels = [&](double firstMm, double secondMm, Method second = Method::Pafc) {
        const Picture picture = drawn(
            {marker(Method::Pafc, 1.0, firstMm, 10.0), marker(second, 100.0, secondMm, 10.0)});
        int dark = 0;
        for (int y = (kFrameTop + kFrameBottom) / 2 - 10; y < (kFrameTop + kFrameBottom) / 2 + 10;
             ++y)
            for (int x = (kFrameLeft + kFrameRight) / 2 - 10;
                 x < (kFrameLeft + kFrameRight) / 2 + 10; ++x)
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
        const Picture part = panel(drawn({marker(Method::Joint, mm, mm, mm)}), kFrameLeft);
        EXPECT_GT(part.count(kJointColour), 30) << mm;
        const auto [left, right, top, bottom] = part.extent(kJointColour);
        EXPECT_GE(left, kFrameLeft - 15) << mm;
        EXPECT_LE(right, kFrameRight + 15) << mm;
        EXPECT_GE(top, kFrameTop - 15) << mm;
        EXPECT_LE(bottom, kFrameBottom + 15) << mm;
    }
}

TEST_F(TradeoffFigure, refusesNoPointsAndAnotherEnding)
{
    const std::string other = directory_.file("tradeoff.bmp");
    EXPECT_THROW((void)writeTradeoffFigure(other, {}), std::invalid_argument);
    EXPECT_TRUE(
        refused(writeTradeoffFigure(other, std::array{marker(Method::Pafc, 1.0, 10.0, 1.0)}), other,
                {".png, .svg or .pdf"}));
    EXPECT_TRUE(directory_.entries().empty());
}

}  // namespace
}  // namespace terratact
