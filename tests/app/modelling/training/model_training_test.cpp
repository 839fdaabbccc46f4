// Tests training a model and comparing two, without a window.
#include "app/modelling/training/model_training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/infer/sampling/watch.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/file/model_file.h"
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

TEST_F(Training, advisesInducingRowsForManyScenes)
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

TEST_F(Training, countsScenesWithHolesAndLearnsThem)
{
    std::vector<Scene> scenes = someScenes(8, 1);
    for (std::size_t k = 0; k < 5; ++k) scenes[k].truth[10].reset();
    scenes[5].truth = {};
    plan.data = written("learn.csv", scenes);
    std::string said;
    const auto model =
        trainModel(plan, {.cancelled = {}, .progress = {}, .notice = [&](const Message& s) {
                              said += s.english() + "\n";
                          }});
    ASSERT_TRUE(model) << model.error().text;
    EXPECT_NE(said.find("1 scenes with unknown values left out"), std::string::npos) << said;
    EXPECT_NE(said.find("5 scenes have unknown heights"), std::string::npos) << said;
    const std::string path = directory.file("model.ttm");
    ASSERT_TRUE(writeModel(path, *model));
    const auto read = readModel(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->data.unknownBins, model->unknownBins);
    EXPECT_EQ(std::ranges::count(read->data.unknownBins, 1U << 10U), 5);
}

TEST_F(Training, reportsTheStartAndEndOfEachBin)
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

}  // namespace
}  // namespace terratact
