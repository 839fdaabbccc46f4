#include "app/modelling/training/model_conditions.h"

#include <gtest/gtest.h>

#include "tests/support/toy_model.h"

namespace terratact {
namespace {

int linesWith(const std::string& text, const std::string& part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(ModelConditions, reportThatNothingIsSingular)
{
    const std::string text = conditionsText(toyModel(), FeatureSet::Paf);
    EXPECT_EQ(text.find("least reciprocal condition number of the paf models: "), 0U) << text;
}

TEST(ModelConditions, nameTheJitterOfEverySingularBin)
{
    ModelData model = toyModel();
    for (Eigen::Index u = 1; u < model.scannedHeights.rows(); u += 2) {
        model.scannedHeights.row(u) = model.scannedHeights.row(u - 1);
        model.features.row(u) = model.features.row(u - 1);
    }
    for (const std::size_t i : {2U, 7U}) model.pa.bins[i].noiseSd = 0.0;
    const std::string text = conditionsText(model, FeatureSet::Pa);
    EXPECT_EQ(linesWith(text, "is singular: jitter 1e-"), 2) << text;
    EXPECT_EQ(linesWith(text, "bin -0.1 m is singular"), 1) << text;
    EXPECT_EQ(linesWith(text, "bin +0.4 m is singular"), 1) << text;
}

TEST(ModelConditions, giveTheReasonWhyABinIsRefused)
{
    ModelData model = toyModel();
    model.pa.bins[4].signalSd = 1e200;  // its square is infinite
    EXPECT_EQ(linesWith(conditionsText(model, FeatureSet::Pa), "bin +0.1 m is refused: "), 1);
}

TEST(ModelConditions, areNotComputedForManyScenes)
{
    ModelData model = toyModel();
    model.scannedHeights.resize(kMaxConditionRows + 1, kBins);
    EXPECT_EQ(conditionsText(model, FeatureSet::Pa),
              "condition of the pa models: not computed for more than 2500 scenes\n");
}

}  // namespace
}  // namespace terratact
