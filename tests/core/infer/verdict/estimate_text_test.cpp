#include "core/infer/verdict/estimate_text.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

/// Returns 100 level draws, of which 30 rise by 0.2 m at bin +0.6.
TerrainEstimate perhapsAStep()
{
    TerrainEstimate estimate;
    estimate.ess.fill(100.0);
    for (int d = 0; d < 100; ++d) {
        Heights h{};
        h[9] = h[10] = d < 30 ? 0.2 : 0.0;
        estimate.draws.push_back(h);
    }
    return estimate;
}

TEST(HiddenByBands, showsStepProbabilityAndTwoHeights)
{
    const auto sentences = hiddenByBands(perhapsAStep());
    ASSERT_EQ(sentences.size(), 3U);
    EXPECT_EQ(sentences[0].english(),
              "a step of more than 0.10 m anywhere ahead, felt or not: P 0.30 ± 0.05, most likely "
              "at +0.5 … +0.6 m (P 0.30)");
    EXPECT_EQ(sentences[1].english(),
              "two heights are likely at +0.6 m: +0.00 m (70 %) or +0.20 m (30 %)");
}

TEST(HiddenByBands, hasALimitAndIsEmptyWithoutDraws)
{
    TerrainEstimate certain = perhapsAStep();
    certain.ess.fill(1000.0);
    certain.draws.resize(1000, certain.draws.back());
    EXPECT_NE(hiddenByBands(certain, 0.25)[0].english().find("P 0.00 ± < 0.01, most likely"),
              std::string::npos)
        << "no number of draws makes it certain";
    EXPECT_TRUE(hiddenByBands(TerrainEstimate{}).empty());
}

}  // namespace
}  // namespace terratact
