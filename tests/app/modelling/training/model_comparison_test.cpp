// Tests the comparison of two models on the same scenes.
#include "app/modelling/training/model_comparison.h"

#include <gtest/gtest.h>

#include <utility>

#include "app/mission/text/comparison_text.h"
#include "app/modelling/training/model_training.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/file/model_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

TEST(Picking, spreadsEvenly)
{
    EXPECT_EQ(evenlyPicked(3, 300), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(evenlyPicked(10, 4), (std::vector<std::size_t>{0, 2, 5, 7}));
    EXPECT_TRUE(evenlyPicked(0, 4).empty());
}

struct Comparing : testing::Test {
    static std::string model(const std::vector<Scene>& scenes, const std::string& name)
    {
        ModelData data = prepareTraining(scenes).model;
        for (BinModelData* bins : {&data.pa, &data.paf})
            for (Hyperparameters& hyper : bins->bins)
                hyper = {Eigen::VectorXd::Constant(bins->mean.size() - 1, 5.0), 0.1, 0.02};
        data.dataHash = std::string(64, 'a');
        trainToyClearances(data);
        const std::string path = files->file(name);
        EXPECT_TRUE(writeModel(path, data));
        return path;
    }
    static void SetUpTestSuite()
    {
        files = new TemporaryDirectory;
        std::vector<Scene> scenes = someScenes(6, 1);
        good = model(scenes, "good.ttm");
        for (Scene& scene : scenes)
            for (auto& height : scene.truth)
                if (height) *height -= 0.1;
        bad = model(scenes, "bad.ttm");
    }
    static void TearDownTestSuite() { delete std::exchange(files, nullptr); }

    void SetUp() override
    {
        plan.robot = absolem();
        plan.oldModel = plan.newModel = good;
        plan.data = files->file("test.csv");
        ASSERT_TRUE(writeScenes(plan.data, someScenes(6, 7)));
    }

    static inline TemporaryDirectory* files = nullptr;
    static inline std::string good, bad;
    ComparisonPlan plan;
};

TEST_F(Comparing, aModelWithItselfIsEqual)
{
    double last = 0.0;
    ComparisonWatch watch;
    watch.progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    plan.mostScenes = 20;
    const auto comparison = compareModels(plan, watch);
    ASSERT_TRUE(comparison) << comparison.error().text;
    EXPECT_EQ(comparison->before.near, comparison->after.near);
    EXPECT_EQ(comparison->before.all, comparison->after.all);
    EXPECT_EQ(comparison->scenes, 20U);
    EXPECT_EQ(comparison->tried, 20U);
    EXPECT_GT(comparison->inFile, 20U);
    EXPECT_GT(comparison->after.near.mean, 0.0);
    ASSERT_TRUE(comparison->nearDifference);
    EXPECT_EQ(*comparison->nearDifference, (Interval{0.0, 0.0}));
    EXPECT_EQ(comparison->newTrained, 0U);
    EXPECT_EQ(last, 1.0);
    EXPECT_TRUE(
        ComparisonWords::sentence(*comparison).contains("the same mean error as the old one"));
    EXPECT_TRUE(ComparisonWords::caution(*comparison).contains("may be chance"));
    EXPECT_TRUE(ComparisonWords::caution(*comparison).contains("20 of the file's"));
}

TEST_F(Comparing, aWorseModelIsReportedAsWorse)
{
    plan.newModel = bad;
    plan.threads = 1;
    const auto comparison = compareModels(plan);
    ASSERT_TRUE(comparison) << comparison.error().text;
    EXPECT_GT(comparison->after.near.mean, 1.5 * comparison->before.near.mean);
    EXPECT_LT(comparison->after.near.coverage, comparison->before.near.coverage);
    ASSERT_TRUE(comparison->nearDifference);
    EXPECT_GT(comparison->nearDifference->low, 0.0);
    EXPECT_TRUE(ComparisonWords::sentence(*comparison).contains("% larger on"));
    EXPECT_FALSE(ComparisonWords::caution(*comparison).contains("chance"));

    plan.threads = 2;
    std::swap(plan.oldModel, plan.newModel);
    const auto swapped = compareModels(plan);
    ASSERT_TRUE(swapped);
    EXPECT_EQ(swapped->after.all, comparison->before.all);
    EXPECT_EQ(swapped->before.all, comparison->after.all);
    EXPECT_TRUE(ComparisonWords::sentence(*swapped).contains("% smaller on"));
}

TEST_F(Comparing, isCancelledBetweenScenes)
{
    int shares = 0;
    ComparisonWatch watch;
    watch.cancelled = [&] { return shares >= 2; };
    watch.progress = [&](double) { ++shares; };
    plan.threads = 1;
    EXPECT_THROW((void)compareModels(plan, watch), Cancelled);
    EXPECT_EQ(shares, 2);
}

TEST_F(Comparing, namesWhatCannotBeCompared)
{
    std::vector<Scene> scenes = someScenes(1, 7);
    for (Scene& scene : scenes) scene.truth.fill(std::nullopt);
    plan.data = files->file("blind.csv");
    ASSERT_TRUE(writeScenes(plan.data, scenes));
    EXPECT_TRUE(refused(compareModels(plan), plan.data, {"no scene has a known height"}));
    plan.data = files->file("test.csv");
    plan.newModel = files->write("torn.ttm", "no model");
    EXPECT_TRUE(refused(compareModels(plan), plan.newModel, {}));
}

TEST_F(Comparing, detectsTheTrainingScenesOfAModel)
{
    const std::string data = files->file("learnt.csv");
    const std::vector<Scene> learnt = someScenes(4, 9);
    ASSERT_TRUE(writeScenes(data, learnt));
    TrainingPlan training;
    training.robot = absolem();
    training.data = data;
    const auto model = trainModel(training);
    ASSERT_TRUE(model);
    plan.newModel = files->file("learnt.ttm");
    ASSERT_TRUE(writeModel(plan.newModel, *model));
    plan.data = data;
    plan.mostScenes = 5;
    const auto comparison = compareModels(plan);
    ASSERT_TRUE(comparison) << comparison.error().text;
    EXPECT_EQ(comparison->newTrained, comparison->scenes);
    EXPECT_EQ(comparison->oldTrained, 0U);
    EXPECT_TRUE(ComparisonWords::caution(*comparison).contains("new model was trained on"));

    plan.data = files->file("subset.csv");
    plan.mostScenes = 20;
    std::vector<Scene> subset(learnt.begin(), learnt.begin() + 8);
    for (Scene& scene : subset) scene.run = "saved again";
    const std::vector<Scene> unseen = someScenes(2, 7);
    subset.insert(subset.end(), unseen.begin(), unseen.begin() + 8);
    ASSERT_TRUE(writeScenes(plan.data, subset));
    const auto ofSubset = compareModels(plan);
    ASSERT_TRUE(ofSubset) << ofSubset.error().text;
    EXPECT_GT(ofSubset->newTrained, 0U);
    EXPECT_LT(ofSubset->newTrained, ofSubset->scenes);
    EXPECT_LE(ofSubset->newTrained, 8U);
    std::swap(plan.oldModel, plan.newModel);
    const auto swapped = compareModels(plan);
    ASSERT_TRUE(swapped);
    EXPECT_EQ(swapped->oldTrained, ofSubset->newTrained);
    EXPECT_EQ(swapped->newTrained, 0U);
    EXPECT_TRUE(ComparisonWords::caution(*swapped).contains("old model was trained on"));
}

}  // namespace
}  // namespace terratact
