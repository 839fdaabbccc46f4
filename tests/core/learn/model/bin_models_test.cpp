#include "core/learn/model/bin_models.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/infer/estimate/quality_preset.h"
#include "core/learn/gp/scene_conditional.h"
#include "core/learn/model/file/model_file.h"
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

TEST(BinModels, sparseModelKeepsItsTrainedNumberOfRows)
{
    ModelData data = toyModel();
    data.inducing = 50;
    const BinModels models(data, FeatureSet::Pa);
    EXPECT_EQ(models.bin(0).rows(), 50);
    EXPECT_EQ(models.bin(0, 20).rows(), 20);
    EXPECT_EQ(&models.bin(0, 80), &models.bin(0));
}

/// Largest differences by single precision: variances relative, means in metres.
struct Differences {
    double variance = 0.0, mean = 0.0;
    double ofVariances = 0.0;  ///< root of the mean square
};

/// Compares at scenes with heights that are shifted by `off` [m].
Differences differences(const BinModels& models, FeatureSet set, int bin,
                        const std::vector<Scene>& scenes, double off, int inducing = 0)
{
    const GaussianProcess& gp = models.bin(bin, inducing);
    std::vector<int> moving(kBins - 1);  // the other heights
    std::iota(moving.begin(), moving.end(), 0);
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    Differences worst;
    long count = 0;
    for (const Scene& scene : scenes) {
        if (!missingFeature(set, scene.s).empty()) continue;
        Eigen::MatrixXd states(kBins - 1, 40);
        for (Eigen::Index c = 0; c < states.cols(); ++c) {
            Heights heights{};
            for (std::size_t i = 0; i < kBins; ++i)
                heights[i] = scene.truth[i].value_or(0.0) + off * normal(rng);
            states.col(c) = models.input(bin, heights, features(set, scene.s)).head(kBins - 1);
        }
        const Eigen::VectorXd x = models.input(bin, {}, features(set, scene.s));
        Eigen::VectorXd mean, meanSingle, single, exact;
        SceneConditional(gp, x, moving, Precision::Single).predict(states, meanSingle, single);
        SceneConditional(gp, x, moving, Precision::Double).predict(states, mean, exact);
        const Eigen::ArrayXd share = (single - exact).array() / exact.array();
        worst.variance = std::max(worst.variance, share.abs().maxCoeff());
        worst.mean = std::max(worst.mean, (meanSingle - mean).cwiseAbs().maxCoeff());
        worst.ofVariances += share.square().sum();
        count += states.cols();
    }
    worst.ofVariances = std::sqrt(worst.ofVariances / static_cast<double>(count));
    return worst;
}

TEST(BinModels, shippedModelKeepsItsSinglePrecisionBounds)
{
    const auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    ASSERT_TRUE(stored) << stored.error().text;
    const std::vector<Scene> scenes = someScenes(2, 5);
    for (const FeatureSet set : {FeatureSet::Pa, FeatureSet::Paf}) {
        const BinModels models(stored->data, set);
        double rows = 0.0;
        for (int bin = 0; bin < static_cast<int>(kBins); ++bin) {
            const GaussianProcess& gp = models.bin(bin);
            ASSERT_EQ(gp.usable(Precision::Single), Precision::Single) << bin;
            rows += std::pow(gp.varianceRows() / static_cast<double>(gp.rows()), 2) / kBins;
            std::cout << "bin " << bin << ": " << gp.varianceRows() << " of " << gp.rows()
                      << " rows; variances off by";
            for (const double off : {0.05, 0.3, 1.0}) {  // from likely to absurd
                const Differences worst = differences(models, set, bin, scenes, off);
                EXPECT_GT(worst.variance, 0.0);
                EXPECT_LE(worst.variance, off < 0.1 ? 2.5e-3 : kSingleVarianceError) << bin;
                EXPECT_LE(worst.ofVariances, off < 0.1 ? 5e-4 : 2e-3) << bin;
                EXPECT_LE(worst.mean, 1e-9) << bin;
                std::cout << fmt::format(" {:.2f} % ({:.3f} %),", 100.0 * worst.variance,
                                         100.0 * worst.ofVariances);
            }
            std::cout << " root of mean square in brackets\n";
        }
        std::cout << "products that are left: " << rows << "\n";
        EXPECT_LT(rows, set == FeatureSet::Pa ? 0.3 : 0.5);
    }
}

TEST(BinModels, presetRowsKeepTheSinglePrecisionBound)
{
    const auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    ASSERT_TRUE(stored) << stored.error().text;
    const std::vector<Scene> scenes = someScenes(2, 5);
    for (const auto& [preset, set] : {std::pair{QualityPreset::Fast, FeatureSet::Pa},
                                      std::pair{QualityPreset::Balanced, FeatureSet::Paf}}) {
        const int few = withPreset({}, preset).inducing;
        const BinModels models(stored->data, set);
        double most = 0.0;
        int single = 0;
        for (int bin = 0; bin < static_cast<int>(kBins); ++bin) {
            single += models.bin(bin, few).usable(Precision::Single) == Precision::Single;
            for (const double off : {0.05, 0.3, 1.0})
                most = std::max(most, differences(models, set, bin, scenes, off, few).variance);
        }
        EXPECT_GE(single, kBins - 1) << "else presets are slower than they could be";
        EXPECT_GT(most, 0.0);
        EXPECT_LE(most, kSingleVarianceError);
        std::cout << few << " rows: variances off by " << 100.0 * most << " % at most\n";
    }
}

}  // namespace
}  // namespace terratact
