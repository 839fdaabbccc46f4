// Tests the weight of generated scenes, and what is held out to choose it.
#include "app/modelling/training/scene_mixing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/modelling/training/model_training.h"
#include "core/learn/data/scene_copies.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/learn/model/file/model_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"
#include "tests/support/toy_sides.h"

namespace terratact {
namespace {

std::vector<TwoTrackScene> scenesOf(const std::vector<std::string>& runs)
{
    std::vector<TwoTrackScene> scenes;
    for (const std::string& run : runs) {
        TwoTrackScene scene;
        scene.run = run;
        scenes.push_back(scene);
    }
    return scenes;
}

TEST(SceneMix, theWeightIsTheShareOfGeneratedScenes)
{
    const auto real = scenesOf({"a", "b"}), generated = scenesOf(std::vector<std::string>(8, "g"));
    EXPECT_EQ(mixedScenes(real, generated, 0.0), real);
    EXPECT_EQ(mixedScenes(real, generated, 0.25).size(), 4U);
    EXPECT_EQ(mixedScenes(real, generated, 0.5).size(), 6U);
    EXPECT_EQ(mixedScenes(real, generated, 1.0).size(), 10U);
    EXPECT_EQ(mixedScenes(real, generated, 1.0)[1].run, "b") << "real scenes come first";
}

TEST(SceneMix, filesAreHeldOutThenRunsThenParts)
{
    const auto real = scenesOf({"a", "a", "b", "c", "c", "d", "e", "e"});
    const auto files = heldOutFolds(real, {0, 3});
    EXPECT_EQ(files.of, (std::vector<std::size_t>{0, 0, 0, 1, 1, 1, 1, 1}));
    EXPECT_EQ(files.by, "2 files");
    const auto runs = heldOutFolds(real, {0});
    EXPECT_EQ(runs.of, (std::vector<std::size_t>{0, 0, 1, 2, 2, 3, 0, 0}));
    EXPECT_EQ(runs.by, "4 groups of 5 runs");
    EXPECT_EQ(heldOutFolds(scenesOf({"a", "b", "a"}), {0}).by, "2 runs");
    const auto parts = heldOutFolds(scenesOf(std::vector<std::string>(8, "a")), {0});
    EXPECT_EQ(parts.of, (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 3, 3}));
    EXPECT_EQ(parts.by, "4 parts of one run");
}

/// The same pose on the same ground, measured again.
Scene measuredAgain(Scene scene)
{
    scene.run += " again";
    for (auto& height : scene.truth)
        if (height) *height += 0.002;
    return scene;
}

/// Returns scenes of different places.
std::vector<Scene> scenesOfPlaces()
{
    std::vector<Scene> places;
    for (const Scene& scene : someScenes(6, 1))
        if (std::ranges::none_of(places, [&scene](const Scene& place) {
                return isNearCopy(place, scene) || isNearCopy(place, measuredAgain(scene));
            }))
            places.push_back(scene);
    return places;
}

TEST(SceneMix, exactCopiesAreNeitherLearntNorJudged)
{
    const std::vector<Scene> once = scenesOfPlaces();
    const HeldOutFolds folds = heldOutFolds(once, {0});
    std::vector<Scene> twice = once;
    for (Scene scene : once) {
        scene.run += " under another name";
        twice.push_back(scene);
    }
    for (const auto& begins : {std::vector<std::size_t>{0}, {0, once.size()}}) {
        const HeldOutFolds same = heldOutFolds(twice, begins);
        EXPECT_EQ(same.by, folds.by);
        ASSERT_EQ(same.count, folds.count);
        for (std::size_t i = 0; i < once.size(); ++i) {
            EXPECT_EQ(same.of[i], folds.of[i]) << i;
            EXPECT_EQ(same.of[once.size() + i], same.count) << i;
        }
        const auto mix =
            chooseMix(twice, same, {}, [&once](const auto& learnt, const auto& judged) {
                EXPECT_EQ(learnt.size() + judged.size(), once.size());
                return std::vector<double>{0.01};
            });
        EXPECT_TRUE(mix);
    }
}

TEST(SceneMix, nearCopiesAreHeldOutWithTheirPlace)
{
    const std::vector<Scene> once = scenesOfPlaces();
    const HeldOutFolds folds = heldOutFolds(once, {0});
    std::vector<Scene> both = once;
    for (const Scene& scene : once) both.push_back(measuredAgain(scene));
    for (const auto& begins : {std::vector<std::size_t>{0}, {0, once.size()}}) {
        const HeldOutFolds same = heldOutFolds(both, begins);
        EXPECT_EQ(same.by, folds.by);
        for (std::size_t i = 0; i < both.size(); ++i)
            EXPECT_EQ(same.of[i], folds.of[i % once.size()]) << i;
    }
    const std::vector<Scene> mixed{once[0], once[1], measuredAgain(once[0]), once[2]};
    const HeldOutFolds files = heldOutFolds(mixed, {0, 2});
    EXPECT_EQ(files.of, (std::vector<std::size_t>{0, 0, 0, 1})) << "a place of its own is left";
    EXPECT_EQ(files.by, "2 files");
}

TEST(SceneMix, mirrorImagesAreCopies)
{
    const std::vector<TwoTrackScene> once = someTrackScenes(4, 1);
    const HeldOutFolds folds = heldOutFolds(once, {0});
    std::vector<TwoTrackScene> twice = once;
    for (const TwoTrackScene& scene : once) twice.push_back(mirrored(scene));
    const HeldOutFolds same = heldOutFolds(twice, {0, once.size()});
    EXPECT_EQ(same.by, folds.by);
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(same.of[i], folds.of[i]) << i;
        EXPECT_EQ(same.of[once.size() + i], same.count) << i;
    }
}

TEST(SceneMix, theSmallestErrorOnHeldOutScenesWins)
{
    const auto real = scenesOf({"a", "b"}), generated = scenesOf(std::vector<std::string>(4, "g"));
    const auto errorWith = [&](std::vector<double> ofGenerated) {
        return [ofGenerated = std::move(ofGenerated)](const std::vector<TwoTrackScene>& learnt,
                                                      const std::vector<TwoTrackScene>& judged) {
            for (const TwoTrackScene& scene : learnt)
                EXPECT_NE(scene.run, judged.front().run) << "learnt and judged at once";
            const double error = ofGenerated.at(learnt.size() - 1);
            return error < 0.0 ? std::vector<double>() : std::vector<double>{error, error};
        };
    };
    const HeldOutFolds folds = heldOutFolds(real, {0});
    const auto mix = chooseMix(real, folds, generated, errorWith({0.05, 0.03, 0.02, 9, 0.04}));
    ASSERT_TRUE(mix) << mix.error().text;
    EXPECT_EQ(mix->weight, 0.5);
    EXPECT_EQ(mix->trials.size(), 4U);
    EXPECT_EQ(mix->trials[1], (CardMix::Trial{0.25, 0.03}));
    EXPECT_NE(mixText(*mix).find("weight 0.5     20.0 mm  chosen"), std::string::npos)
        << mixText(*mix);
    const auto equal = chooseMix(real, folds, generated, errorWith({-1, 0.02, 0.03, 9, 0.02}));
    ASSERT_TRUE(equal);
    EXPECT_EQ(equal->weight, 1.0) << "the larger one of equal errors";
    EXPECT_EQ(equal->trials.size(), 3U) << "one real scene alone trains no model";
    EXPECT_FALSE(chooseMix(real, folds, generated, errorWith({-1, -1, -1, -1, -1})));
}

/// A training of two tracks that keeps a model of one plane.
struct MixTraining : testing::Test {
    void SetUp() override
    {
        plan.robot = absolem();
        plan.plane = directory.file("plane.ttm");
        EXPECT_TRUE(writeModel(plan.plane, toyModel()));
        plan.tracks = written("real.csv", someTrackScenes(12, 1));
    }
    std::string written(const std::string& name, const std::vector<TwoTrackScene>& scenes)
    {
        return directory.write(name, twoTrackScenesText(scenes));
    }

    TemporaryDirectory directory;
    TrainingPlan plan;
};

TEST_F(MixTraining, wrongGeneratedScenesAreLeftOut)
{
    const auto real = someTrackScenes(12, 1);
    const auto half = real.begin() + std::ssize(real) / 2;
    plan.tracks = written("first.csv", {real.begin(), half});
    plan.moreTracks = {written("second.csv", {half, real.end()})};
    auto wrong = someTrackScenes(6, 2);
    for (TwoTrackScene& scene : wrong)
        for (auto& side : scene.truth)
            for (std::size_t i = 0; i < kBins; ++i)
                if (side[i]) *side[i] += i % 2 == 0 ? 0.3 : -0.3;
    plan.generated = {written("wrong.csv", wrong)};
    std::optional<CardMix> mix;
    TrainingWatch watch;
    watch.mix = [&](const CardMix& chosen) { mix = chosen; };
    const auto model = trainModel(plan, watch);
    ASSERT_TRUE(model) << model.error().text;
    ASSERT_TRUE(mix);
    EXPECT_EQ(mix->weight, 0.0) << mixText(*mix);
    EXPECT_EQ(mix->trials.size(), 4U);
    EXPECT_EQ(mix->heldOut, "2 files");
    EXPECT_EQ(model->sides.heights, prepareSides(real).rows.heights);
}

TEST_F(MixTraining, aRepeatedFileChangesNoError)
{
    plan.tracks = written("few.csv", someTrackScenes(5, 1));
    plan.generated = {written("generated.csv", someTrackScenes(3, 2))};
    std::vector<CardMix> mixes;
    TrainingWatch watch;
    watch.mix = [&](const CardMix& chosen) { mixes.push_back(chosen); };
    const auto once = trainModel(plan, watch);
    plan.moreTracks = {plan.tracks};
    const auto twice = trainModel(plan, watch);
    ASSERT_TRUE(once && twice);
    ASSERT_EQ(mixes.size(), 2U);
    EXPECT_EQ(mixes[1], mixes[0]);
    EXPECT_EQ(twice->sides.heights, once->sides.heights);
}

TEST_F(MixTraining, tooFewRealScenesAreRefused)
{
    const auto few = someTrackScenes(1, 1);
    plan.tracks = written("few.csv", {few[0], few[1]});
    plan.generated = {written("generated.csv", {few[2]})};
    EXPECT_TRUE(refused(trainModel(plan), plan.tracks, {"too few", "any weight"}));
}

TEST_F(MixTraining, wrongGeneratedPlanesAreLeftOut)
{
    const auto scenes = someScenes(10, 1);
    const auto half = scenes.begin() + std::ssize(scenes) / 2;
    auto wrong = someScenes(3, 2);
    for (Scene& scene : wrong)
        for (std::size_t i = 0; i < kBins; ++i)
            if (scene.truth[i]) *scene.truth[i] += i % 2 == 0 ? 0.3 : -0.3;
    plan = TrainingPlan();
    plan.robot = absolem();
    plan.data = directory.write("first.csv", scenesText({scenes.begin(), half}));
    plan.moreData = {directory.write("second.csv", scenesText({half, scenes.end()}))};
    plan.generated = {directory.write("wrong.csv", scenesText(wrong))};
    std::optional<CardMix> ofPlane, ofTracks;
    TrainingWatch watch;
    watch.planeMix = [&](const CardMix& chosen) { ofPlane = chosen; };
    watch.mix = [&](const CardMix& chosen) { ofTracks = chosen; };
    const auto model = trainModel(plan, watch);
    ASSERT_TRUE(model) << model.error().text;
    ASSERT_TRUE(ofPlane);
    EXPECT_FALSE(ofTracks);
    EXPECT_EQ(ofPlane->weight, 0.0) << mixText(*ofPlane);
    EXPECT_EQ(ofPlane->heldOut, "2 files");
    EXPECT_EQ(model->heights, prepareTraining(scenes).model.heights);
    plan.generated.clear();
    const auto alone = trainModel(plan);
    ASSERT_TRUE(alone);
    EXPECT_EQ(model->paf.bins[3].noiseSd, alone->paf.bins[3].noiseSd);
    EXPECT_NE(model->dataHash, alone->dataHash) << "the hash is of other files";
}

TEST_F(MixTraining, goodGeneratedPlanesAreLearntToo)
{
    const auto real = someScenes(6, 1), generated = someScenes(6, 2);
    plan = TrainingPlan();
    plan.robot = absolem();
    plan.data = directory.write("real.csv", scenesText(real));
    plan.generated = {directory.write("generated.csv", scenesText(generated))};
    std::optional<CardMix> mix;
    TrainingWatch watch;
    watch.planeMix = [&](const CardMix& chosen) { mix = chosen; };
    const auto model = trainModel(plan, watch);
    ASSERT_TRUE(model) << model.error().text;
    ASSERT_TRUE(mix);
    EXPECT_GT(mix->weight, 0.0) << mixText(*mix);
    EXPECT_EQ(model->heights.rows(),
              prepareTraining(mixedScenes(real, generated, mix->weight)).used);
}

TEST_F(MixTraining, generatedScenesThatNothingLearnsAreRefused)
{
    const std::string planes = directory.write("planes.csv", scenesText(someScenes(2, 3)));
    plan.generated = {planes};
    EXPECT_TRUE(refused(trainModel(plan), planes, {"one plane", "--plane", "--data"}));
    TrainingPlan ofPlane;
    ofPlane.robot = absolem();
    ofPlane.data = planes;
    ofPlane.generated = {written("sides.csv", someTrackScenes(2, 3))};
    EXPECT_TRUE(refused(trainModel(ofPlane), ofPlane.generated[0], {"left and right", "--tracks"}));
}

TEST_F(MixTraining, furtherFilesAreLearntToo)
{
    const auto scenes = someTrackScenes(12, 1);
    const auto half = scenes.begin() + std::ssize(scenes) / 2;
    plan.tracks = written("first.csv", {scenes.begin(), half});
    plan.moreTracks = {written("second.csv", {half, scenes.end()})};
    const auto joined = trainModel(plan);
    ASSERT_TRUE(joined) << joined.error().text;
    plan.tracks = directory.file("real.csv");
    plan.moreTracks.clear();
    const auto whole = trainModel(plan);
    ASSERT_TRUE(whole);
    EXPECT_EQ(joined->sides.heights, whole->sides.heights);
    EXPECT_NE(joined->sidesHash, whole->sidesHash) << "the hash is of other files";
}

TEST_F(MixTraining, furtherPlanesAreLearntToo)
{
    const auto scenes = someScenes(8, 1);
    const auto half = scenes.begin() + std::ssize(scenes) / 2;
    const auto plane = [&](const std::string& name, const std::vector<Scene>& some) {
        return directory.write(name, scenesText(some));
    };
    plan = TrainingPlan();
    plan.robot = absolem();
    plan.data = plane("first.csv", {scenes.begin(), half});
    plan.moreData = {plane("second.csv", {half, scenes.end()})};
    const auto joined = trainModel(plan);
    ASSERT_TRUE(joined) << joined.error().text;
    plan.data = plane("whole.csv", scenes);
    plan.moreData.clear();
    const auto whole = trainModel(plan);
    ASSERT_TRUE(whole);
    EXPECT_EQ(joined->heights, whole->heights);
    EXPECT_NE(joined->dataHash, whole->dataHash);
    plan.moreData = {directory.file("missing.csv")};
    EXPECT_TRUE(refused(trainModel(plan), plan.moreData[0], {}));
}

}  // namespace
}  // namespace terratact
