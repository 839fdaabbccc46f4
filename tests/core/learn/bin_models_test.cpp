#include "core/learn/bin_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/learn/model_file.h"
#include "core/learn/scene_conditional.h"
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

TEST(BinModels, ofTheShippedModelAreInSinglePrecisionWithinTheBoundOfTheirProcesses)
{
    const auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    ASSERT_TRUE(stored) << stored.error().text;
    const BinModels models(stored->data, FeatureSet::Paf);
    const std::vector<Scene> scenes = someScenes(2, 5);
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    for (const int bin : {0, 5, 8, 10}) {
        const GaussianProcess& gp = models.bin(bin);
        ASSERT_EQ(gp.usable(Precision::Single), Precision::Single) << bin;
        const double sd = gp.hyperparameters().noiseSd;
        std::vector<int> moving(kBins - 1);  // the other heights
        std::iota(moving.begin(), moving.end(), 0);
        double worst = 0.0, worstSd = 0.0;
        for (const Scene& scene : scenes) {
            if (!missingFeature(FeatureSet::Paf, scene.s).empty()) continue;
            const Eigen::VectorXd x = models.input(bin, {}, features(FeatureSet::Paf, scene.s));
            Eigen::MatrixXd states(kBins - 1, 40);  // from likely to absurd
            for (double& v : states.reshaped()) v = 1.5 * normal(rng);
            Eigen::VectorXd mean, single, exact;
            SceneConditional(gp, x, moving, Precision::Single).predict(states, mean, single);
            SceneConditional(gp, x, moving, Precision::Double).predict(states, mean, exact);
            worst = std::max(worst, (single - exact).cwiseAbs().maxCoeff());
            worstSd =
                std::max(worstSd, (single.cwiseSqrt() - exact.cwiseSqrt()).cwiseAbs().maxCoeff());
        }
        EXPECT_GT(worst, 0.0);
        EXPECT_LE(worst, kSingleErrorElsewhere * gp.singleError()) << bin;
        EXPECT_LE(worstSd, 5e-3 * sd) << bin;
        std::cout << "bin " << bin << ": " << worst / gp.singleError() << " of singleError(), "
                  << worstSd << " m, " << worstSd / sd << " of the noise sd\n";
    }
}

}  // namespace
}  // namespace terratact
