// Tests training a model and comparing two, without a window.
#include "app/modelling/model_training.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <set>
#include <utility>

#include "app/mission/comparison_text.h"
#include "app/modelling/model_comparison.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/model_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

struct Training : testing::Test {
    void SetUp() override
    {
        plan.robot = absolem();
        plan.data = written("learn.csv", someScenes(4, 1));
    }
    std::string written(const std::string& name, const std::vector<Scene>& scenes)
    {
        const std::string path = directory.file(name);
        EXPECT_TRUE(writeScenes(path, scenes));
        return path;
    }

    TemporaryDirectory directory;
    TrainingPlan plan;
};

TEST_F(Training, tellsOfInducingRowsWhereThereAreManyScenes)
{
    const std::vector<Scene> few = someScenes(4, 1);
    std::vector<Scene> scenes;
    // Varies the rear flippers, because a repeated scene does not count as a row of the conditionals.
    for (double rear = 0.0; scenes.size() <= 11 * kManyRows / 10; rear += 0.02)
        for (Scene scene : few) {
            scene.s.rear += rear;
            scenes.push_back(std::move(scene));
        }
    plan.conditionalRows = 20'000;
    const auto noticesOf = [&](const std::vector<Scene>& all) {
        plan.data = written("learn.csv", all);
        std::string said;
        EXPECT_THROW(
            (void)trainModel(plan, {.cancelled = [] { return true; },
                                    .progress = {},
                                    .notice = [&](const Message& s) { said += s.english(); }}),
            Cancelled);
        return said;
    };
    EXPECT_NE(noticesOf(scenes).find("--inducing 1200"), std::string::npos);
    plan.inducing = 600;
    EXPECT_EQ(noticesOf(scenes).find("--inducing"), std::string::npos);
    plan.inducing = 0;
    scenes.resize(kManyRows);
    EXPECT_EQ(noticesOf(scenes).find("--inducing"), std::string::npos);
}

TEST_F(Training, saysWhenEachBinOfEachKindBeginsAndEnds)
{
    std::map<std::pair<TrainingKind, int>, int> begun, ended;
    double last = 0.0;
    TrainingWatch watch;
    watch.progress = [&](const TrainingStep& step) {
        const std::pair job(step.kind, step.bin);
        if (step.event == TrainingEvent::Begun) {
            ++begun[job];
        } else {
            EXPECT_EQ(begun[job], 1);
            ++ended[job];
        }
        EXPECT_GE(step.share, last);
        EXPECT_EQ(step.stageTotal, 2 * kBins);
        last = step.share;
    };
    plan.threads = 2;
    const auto model = trainModel(plan, watch);
    ASSERT_TRUE(model) << model.error().text;
    EXPECT_EQ(begun.size(), kTrainingKinds.size() * kBins);
    EXPECT_EQ(ended.size(), begun.size());
    for (const auto& [job, times] : ended) EXPECT_EQ(times, 1);
    EXPECT_NEAR(last, 1.0, 1e-9);

    plan.threads = 1;
    const auto again = trainModel(plan);
    ASSERT_TRUE(again);
    EXPECT_EQ(contentHash(*again), contentHash(*model)) << "threads and a watch change nothing";
}

TEST_F(Training, isCancelledInTheMiddleOfASearch)
{
    // The first search alone polls more often than this.
    constexpr int kAsked = 50;
    bool begun = false;
    int asked = 0;
    int ended = 0;
    TrainingWatch watch;
    watch.cancelled = [&] { return begun && ++asked > kAsked; };
    watch.progress = [&](const TrainingStep& step) {
        begun = true;
        if (step.event != TrainingEvent::Begun) ++ended;
    };
    plan.threads = 1;
    EXPECT_THROW((void)trainModel(plan, watch), Cancelled);
    EXPECT_EQ(ended, 0);
    EXPECT_EQ(asked, kAsked + 1) << "it goes on after it was told to stop";
}

TEST_F(Training, namesFileAndLineOfWhatIsWrong)
{
    std::string text = contentOf(plan.data);
    const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
    text.insert(third, "1,");
    plan.data = directory.write("bad.csv", text);
    EXPECT_TRUE(refused(trainModel(plan), plan.data, {"line 3"}));
    plan.data = written("few.csv", {someScenes(1, 1).front()});
    EXPECT_TRUE(refused(trainModel(plan), plan.data, {"at least 30 scenes"}));
}

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
    EXPECT_FALSE(comparison->newLearntThese);
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

TEST_F(Comparing, saysWhatCannotBeCompared)
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

TEST_F(Comparing, knowsTheFileThatAModelLearntFrom)
{
    const std::string data = files->file("learnt.csv");
    ASSERT_TRUE(writeScenes(data, someScenes(4, 1)));
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
    EXPECT_TRUE(comparison->newLearntThese);
    EXPECT_FALSE(comparison->oldLearntThese);
    EXPECT_TRUE(ComparisonWords::caution(*comparison).contains("was trained on this file"));
}

}  // namespace
}  // namespace terratact
