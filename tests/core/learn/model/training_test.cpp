#include "core/learn/model/training.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "core/learn/gp/likelihood.h"
#include "core/learn/model/surface_rows.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

TEST(PrepareTraining, standardisesHeightsAndFeatures)
{
    const TrainingSet set = prepareTraining(someScenes(6, 3));
    EXPECT_EQ(set.leftOut, 0);
    EXPECT_EQ(set.model.heights.rows(), set.used);
    EXPECT_EQ(set.model.pa.mean.size(), 11 + 3);
    EXPECT_EQ(set.model.paf.mean.size(), 11 + 11);
    const Eigen::MatrixXd z =
        standardised(rawInputs(set.model, FeatureSet::Paf), set.model.paf.mean, set.model.paf.sd);
    for (Eigen::Index d = 0; d < z.cols(); ++d) {
        EXPECT_NEAR(z.col(d).mean(), 0.0, 1e-10);
        EXPECT_NEAR(z.col(d).squaredNorm() / static_cast<double>(z.rows()), 1.0, 1e-10);
    }
}

TEST(PrepareTraining, leavesOutScenesWithUnknownValues)
{
    auto scenes = someScenes(6, 3);
    scenes[2].truth = {};
    scenes[5].s.force[0].reset();
    const TrainingSet set = prepareTraining(scenes);
    EXPECT_EQ(set.leftOut, 2);
    EXPECT_EQ(set.withHoles, 0);
    EXPECT_TRUE(set.model.unknownBins.empty());
    EXPECT_EQ(set.used + set.exactCopies, static_cast<int>(scenes.size()) - 2);
}

TEST(PrepareTraining, usesScenesForTheBinsTheyKnow)
{
    auto scenes = someScenes(6, 3);
    const TrainingSet whole = prepareTraining(scenes);
    scenes[0].truth[4].reset();
    scenes[0].truthSd[4] = 0.1;
    const TrainingSet set = prepareTraining(scenes);
    EXPECT_EQ(set.leftOut, 0);
    EXPECT_EQ(set.withHoles, 1);
    EXPECT_EQ(set.used, whole.used);
    const ModelData& model = set.model;
    ASSERT_EQ(std::ssize(model.unknownBins), set.used);
    EXPECT_EQ(model.scannedHeights.rows(), whole.model.scannedHeights.rows() - 1);
    EXPECT_EQ(model.heightSd.rows(), 0) << "an unknown height has no sd";
    for (Eigen::Index u = 0; u < model.scannedHeights.rows(); ++u)
        EXPECT_EQ(model.unknownBins[static_cast<std::size_t>(u)], 0U)
            << "complete scenes come first";
    const Eigen::Index hole = model.scannedHeights.rows();
    EXPECT_EQ(model.unknownBins[static_cast<std::size_t>(hole)], 1U << 4U);
    EXPECT_EQ(model.heights(hole, 4), 0.0);
    EXPECT_EQ(model.heights(hole, 5), *scenes[0].truth[5]);
    EXPECT_EQ(std::ssize(completeRows(model)), set.used - 1);
}

TEST(PrepareTraining, needsEnoughCompleteScenes)
{
    auto scenes = someScenes(6, 3);
    for (std::size_t k = 20; k < scenes.size(); ++k) scenes[k].truth[10].reset();
    try {
        (void)prepareTraining(scenes);
        FAIL() << "20 complete scenes are too few";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("with unknown heights"), std::string::npos);
    }
}

TEST(PrepareTraining, refusesTooFewScenesAndInputsThatNeverVary)
{
    auto scenes = someScenes(6, 3);
    EXPECT_THROW((void)prepareTraining({scenes.begin(), scenes.begin() + 20}),
                 std::invalid_argument);
    for (Scene& scene : scenes) scene.s.rear = 0.1;
    EXPECT_THROW((void)prepareTraining(scenes), std::invalid_argument);
}

TEST(TrainBin, findsAHigherLikelihoodThanItsStart)
{
    const ModelData model = prepareTraining(someScenes(8, 5)).model;
    TrainingOptions options;
    options.subset = 60;
    options.subsetEvaluations = 40;
    const TrainedBin trained = trainBin(model, FeatureSet::Pa, 5, options);
    const Eigen::MatrixXd X =
        withoutBin(standardised(rawInputs(model, FeatureSet::Pa), model.pa.mean, model.pa.sd), 5);
    const Eigen::VectorXd y = model.scannedHeights.col(5).array() - model.pa.mean[5];
    const Hyperparameters guess{Eigen::VectorXd::Constant(13, 3.6), model.pa.sd[5],
                                0.2 * model.pa.sd[5]};
    EXPECT_NEAR(trained.logLikelihood, -negativeLogLikelihood(X, y, trained.hyper).negativeLog,
                1e-6);
    EXPECT_GT(trained.logLikelihood, -negativeLogLikelihood(X, y, guess).negativeLog + 10.0);
    EXPECT_GT(trained.hyper.noiseSd, 0.004);  // the truth has the scanner's noise of 12 mm
    EXPECT_LT(trained.hyper.noiseSd, 0.06);
}

TEST(TrainBin, searchesOnNoMoreRowsThanItIsGiven)
{
    const ModelData model = prepareTraining(someScenes(8, 5)).model;
    TrainingOptions options;
    options.subset = 40;
    options.subsetEvaluations = 10;
    options.fullEvaluations = 5;
    const auto perRow = [&](double l) { return l / static_cast<double>(model.heights.rows()); };
    const double all = perRow(trainBin(model, FeatureSet::Pa, 5, options).logLikelihood);
    options.fullRows = 50;
    const double some = perRow(trainBin(model, FeatureSet::Pa, 5, options).logLikelihood);
    EXPECT_LT(some, 0.8 * all);  // a sum over fewer rows
    EXPECT_GT(some, 0.0);
}

TEST(TrainBin, givesTheSameForTheSameSeedAndStopsWhenCancelled)
{
    const ModelData model = prepareTraining(someScenes(6, 5)).model;
    TrainingOptions options;
    options.subset = 40;
    options.fullEvaluations = 5;
    const TrainedBin a = trainBin(model, FeatureSet::Paf, 0, options);
    const TrainedBin b = trainBin(model, FeatureSet::Paf, 0, options);
    EXPECT_EQ(a.hyper.lengthScale, b.hyper.lengthScale);
    EXPECT_EQ(a.logLikelihood, b.logLikelihood);
    struct Stop {};
    int polls = 0;
    (void)trainBin(model, FeatureSet::Paf, 0, options, [&] { ++polls; });
    EXPECT_GT(polls, 100);
    for (const int last : {1, 2, 3, polls / 2, polls}) {
        int asked = 0;
        const Poll stop = [&] {
            if (++asked == last) throw Stop{};
        };
        EXPECT_THROW((void)trainBin(model, FeatureSet::Paf, 0, options, stop), Stop);
        EXPECT_EQ(asked, last) << "asked no more once it threw";
    }
}

TEST(PrepareTraining, keepsTheSdOfHeights)
{
    auto scenes = someScenes(6, 3);
    EXPECT_EQ(prepareTraining(scenes).model.heightSd.rows(), 0);
    scenes[0].truthSd[2] = 0.05;
    const TrainingSet set = prepareTraining(scenes);
    ASSERT_EQ(set.model.heightSd.rows(), set.used);
    EXPECT_EQ(set.model.heightSd(0, 2), 0.05);
    EXPECT_EQ(set.model.heightSd.sum(), 0.05);
}

TEST(TrainBin, explainsNoiseOfRowsByTheirSd)
{
    auto scenes = someScenes(8, 5);
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < scenes.size(); k += 2) {
        *scenes[k].truth[5] += 0.15 * normal(rng);
        scenes[k].truthSd[5] = 0.15;
    }
    TrainingOptions options;
    options.subset = 60;
    options.subsetEvaluations = 40;
    const double told =
        trainBin(prepareTraining(scenes).model, FeatureSet::Pa, 5, options).hyper.noiseSd;
    for (Scene& scene : scenes) scene.truthSd = {};
    const double untold =
        trainBin(prepareTraining(scenes).model, FeatureSet::Pa, 5, options).hyper.noiseSd;
    EXPECT_GT(untold, 0.08);
    EXPECT_LT(told, 0.06);
}

}  // namespace
}  // namespace terratact
