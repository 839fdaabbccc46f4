#include "app/figures/evaluation_figure.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "tests/support/picture.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr unsigned kPa = 0x7b8794,
                   kPafc = 0x12804a;  // Colours of app/figures/evaluation_figure.cpp.

MethodSummary summary(const std::string& label, double scale)
{
    MethodSummary m;
    m.label = label;
    for (ErrorStatistics& s : m.bin) {
        s.n = 10;
        s.q1 = 0.5 * scale;
        s.median = scale;
        s.q3 = 2.0 * scale;
    }
    return m;
}

class EvaluationFigure : public testing::Test {
protected:
    TemporaryDirectory directory_;
    std::string path_ = directory_.file("figure.png");
};

TEST_F(EvaluationFigure, ofHistogramsHasBarsAsHighAsTheirShares)
{
    // PA has half of its errors in its highest class, PAFc three quarters.
    const std::vector<ErrorHistogram> h{{"pa", 0.01, {4, 2, 2}, 8}, {"pafc", 0.01, {0, 1, 3}, 4}};
    ASSERT_TRUE(writeHistogramFigure(path_, h));
    const Picture picture = readPng(path_);
    EXPECT_EQ(picture.width, 1200);
    EXPECT_EQ(picture.height, 700);
    const double floor = 590.0;
    const auto pa = picture.extent(kPa);
    const auto pafc = picture.extent(kPafc);
    EXPECT_NEAR((floor - pa[2]) / (floor - pafc[2]), 0.50 / 0.75, 0.01);
    EXPECT_GT(picture.count(kPa),
              picture.count(kPafc) * 8 / 9);  // equal areas except for the legend
}

TEST_F(EvaluationFigure, ofQuartilesStaysInsideTheFrameWhateverTheErrors)
{
    for (const double scale : {1e-5, 0.01, 0.7, 40.0}) {
        ASSERT_TRUE(writeQuartileFigure(
            path_, std::vector{summary("pa", scale), summary("pafc", 0.4 * scale)}));
        const auto [left, right, top, bottom] = readPng(path_).extent(kPa);
        EXPECT_GE(left, 84) << scale;
        EXPECT_LE(right, 1170) << scale;
        EXPECT_GE(top, 84) << scale;
        if (scale > 0.001) {
            EXPECT_LT(top, 240) << scale;  // and it uses the height
        }
    }
}

TEST_F(EvaluationFigure, hasFourToTenGridLinesWhateverTheErrors)
{
    for (const double scale : {0.0006, 0.01, 0.012, 0.024, 0.026, 0.7, 40.0}) {
        ASSERT_TRUE(writeQuartileFigure(path_, std::vector{summary("pa", scale)}));
        const Picture picture = readPng(path_);
        int lines = 0;
        for (int y = 80; y < 595; ++y)  // right of the last mark
            if (picture.at(1165, y) != 0xffffffU && picture.at(1165, y - 1) == 0xffffffU) ++lines;
        EXPECT_GE(lines, 4) << scale;
        EXPECT_LE(lines, 10) << scale;
    }
}

TEST_F(EvaluationFigure, leavesOutABinWithoutErrors)
{
    MethodSummary m = summary("pafc", 0.01);
    m.bin[10] = {};
    ASSERT_TRUE(writeQuartileFigure(path_, std::vector{m}));
    EXPECT_LT(readPng(path_).extent(kPafc)[1], 1170 - 98);  // the last of eleven columns is empty
}

TEST_F(EvaluationFigure, ofManySeriesIsWiderAndHasMutedHollowBaselines)
{
    constexpr unsigned kFlat = 0xb0a18a;
    std::vector<MethodSummary> many;
    for (const char* label : {"pa", "pac", "pafc", "clearance", "local", "flat"})
        many.push_back(summary(label, 0.02));
    ASSERT_TRUE(writeQuartileFigure(path_, many));
    const Picture picture = readPng(path_);
    EXPECT_EQ(picture.width, 1800);
    EXPECT_GT(picture.count(kFlat), 500);
    EXPECT_LT(picture.count(kFlat), picture.count(kPa) / 2);
    EXPECT_LE(picture.extent(kFlat)[1], 1770);
}

TEST_F(EvaluationFigure, ofPitHasOnePanelPerLabelWithBarsOfTheShares)
{
    const std::vector<ErrorHistogram> h{{"pa", 0.5, {10, 10}, 20}, {"pafc", 0.5, {15, 5}, 20}};
    ASSERT_TRUE(writePitFigure(path_, h));
    const Picture picture = readPng(path_);
    const auto pa = picture.extent(kPa);
    const auto pafc = picture.extent(kPafc);
    EXPECT_LT(pa[1], pafc[0]);  // side by side
    EXPECT_NEAR((pa[3] - pa[2]) / static_cast<double>(pafc[3] - pafc[2]), 0.50 / 0.75, 0.03);
    EXPECT_EQ(pa[3], pafc[3]);
    EXPECT_THROW((void)writePitFigure(path_, {}), std::invalid_argument);
    const std::vector<ErrorHistogram> eight(8, h[0]);
    ASSERT_TRUE(writePitFigure(path_, eight));
    EXPECT_GT(readPng(path_).height, 700);
    EXPECT_LT(readPng(path_).extent(kPa)[3], readPng(path_).height - 20);
}

TEST_F(EvaluationFigure, ofNothingOrOfUnequalClassesIsRefused)
{
    EXPECT_THROW((void)writeHistogramFigure(path_, {}), std::invalid_argument);
    EXPECT_THROW((void)writeQuartileFigure(path_, {}), std::invalid_argument);
    const std::vector<ErrorHistogram> h{{"pa", 0.01, {1, 2}, 3}, {"pac", 0.02, {1, 2}, 3}};
    EXPECT_THROW((void)writeHistogramFigure(path_, h), std::invalid_argument);
    const std::vector<ErrorHistogram> more{{"pa", 0.01, {1, 2}, 3}, {"pac", 0.01, {1, 2, 0}, 3}};
    EXPECT_THROW((void)writeHistogramFigure(path_, more), std::invalid_argument);
    const std::string other = directory_.file("figure.txt");
    EXPECT_TRUE(
        refused(writeHistogramFigure(other, std::span(h).first(1)), other, {".png, .svg or .pdf"}));
    EXPECT_TRUE(directory_.entries().empty());
}

}  // namespace
}  // namespace terratact
