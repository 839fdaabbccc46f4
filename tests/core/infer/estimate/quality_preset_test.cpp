#include "core/infer/estimate/quality_preset.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(QualityPreset, namesGoBackAndForth)
{
    for (const QualityPreset q : kQualityPresets) EXPECT_EQ(qualityPresetFromName(name(q)), q);
    EXPECT_FALSE(qualityPresetFromName("best"));
}

TEST(QualityPreset, changesSamplingSettingsOnly)
{
    Settings settings;
    settings.method = Method::Clearance;
    settings.seed = 99;
    settings.forceThreshold = 3.5;
    const Settings fast = withPreset(settings, QualityPreset::Fast);
    const Settings accurate = withPreset(settings, QualityPreset::Accurate);
    EXPECT_EQ(fast.method, settings.method);
    EXPECT_EQ(fast.seed, settings.seed);
    EXPECT_EQ(fast.forceThreshold, settings.forceThreshold);
    EXPECT_LT(fast.draws, accurate.draws);
    EXPECT_GT(fast.inducing, 0);
    EXPECT_EQ(accurate.inducing, 0) << "all rows";
    EXPECT_LT(accurate.chains, fast.chains);
}

}  // namespace
}  // namespace terratact
