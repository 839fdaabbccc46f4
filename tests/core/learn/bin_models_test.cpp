#include "core/learn/bin_models.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/toy_model.h"

namespace terratact {
namespace {

TEST(BinModels, makeOneProcessPerBinAndNumberOfInducingRows)
{
    ModelData data = toyModel();
    const BinModels models(data, FeatureSet::Paf);
    const auto all = static_cast<int>(data.scannedHeights.rows());
    EXPECT_EQ(models.bin(3).rows(), all);
    EXPECT_EQ(models.bin(3, 40).rows(), 40);
    EXPECT_EQ(&models.bin(3, 40), &models.bin(3, 40));
    EXPECT_EQ(&models.bin(3, all + 5), &models.bin(3));
    EXPECT_EQ(models.bin(4, 30).rows(), 30);
    EXPECT_THROW((void)models.bin(3, -1), std::invalid_argument);
    EXPECT_THROW((void)models.bin(11), std::invalid_argument);
}

TEST(BinModels, ofASparseModelPredictThroughNoMoreRowsThanItWasTrainedFor)
{
    ModelData data = toyModel();
    data.inducing = 50;
    const BinModels models(data, FeatureSet::Pa);
    EXPECT_EQ(models.bin(0).rows(), 50);
    EXPECT_EQ(models.bin(0, 20).rows(), 20);
    EXPECT_EQ(&models.bin(0, 80), &models.bin(0));
}

}  // namespace
}  // namespace terratact
