// Tests what the operator reads about a quality preset.
#include "app/mission/text/preset_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace terratact {
namespace {

const std::vector<PresetCost> kCosts{
    {Method::Local, QualityPreset::Fast, 250, 16, 16, 175, 0.5, 0.0, 25.0, 1.0},
    {Method::Pac, QualityPreset::Fast, 250, 16, 16, 175, 4.0, 11.3, 34.0, 0.13}};

TEST(PresetTexts, showTimeErrorAndConvergence)
{
    const QString line = presetLines(Method::Pac, kCosts).at(0);
    for (const char* part : {"fast: 4.0 ms", "± 11.3 mm", "mean error 34 mm", "13 % of scenes"})
        EXPECT_TRUE(line.contains(QString::fromUtf8(part))) << line.toStdString();
    EXPECT_EQ(presetEntries(Method::Pac, kCosts).at(0),
              QString::fromUtf8("fast: 4.0 ms, 34 mm (± 11.3 mm), 13 % converge"));
}

TEST(PresetTexts, aClosedFormHasNoChains)
{
    const QString line = presetLines(Method::Local, kCosts).at(0);
    EXPECT_TRUE(line.contains("exact quantiles")) << line.toStdString();
    EXPECT_FALSE(line.contains("converge")) << line.toStdString();
}

TEST(PresetTexts, markPresetsThatWereNotMeasured)
{
    for (const Method method : {Method::Local, Method::Pafc}) {
        const QStringList lines = presetLines(method, kCosts);
        EXPECT_EQ(lines.size(), static_cast<qsizetype>(kQualityPresets.size()));
        EXPECT_EQ(lines.filter("not measured").size(), method == Method::Local ? 2 : 3)
            << "the costs of another method count for nothing";
    }
    EXPECT_EQ(presetEntries(Method::Local, kCosts).at(2), "accurate: not measured");
}

}  // namespace
}  // namespace terratact
