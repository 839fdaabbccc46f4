#include "core/learn/data/scene_copies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/infer/estimator.h"
#include "core/learn/data/columns.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/surface_rows.h"
#include "core/learn/model/training.h"
#include "core/sim/sensor_noise.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

std::vector<Scene> scenesOf(int runs)
{
    return someScenes(runs, 5);
}

/// The same pose on the same ground, pressed again.
Scene again(const Scene& scene, std::mt19937_64& rng)
{
    Scene copy = scene;
    copy.run += " again";
    copy.s = noisy(scene.s, {}, absolem().forceSaturation, rng);
    Heights heights{};
    for (std::size_t i = 0; i < kBins; ++i) heights[i] = *scene.truth[i];
    heights = noisy(heights, {}, rng);
    for (std::size_t i = 0; i < kBins; ++i) copy.truth[i] = heights[i];
    return copy;
}

TEST(SceneCopies, trainingUsesADuplicatedFileOnce)
{
    const std::vector<Scene> once = scenesOf(20);
    std::vector<Scene> twice = once;
    for (Scene scene : once) {
        scene.run += " under another name";
        scene.time += 3.0;
        twice.push_back(scene);
    }
    const TrainingSet first = prepareTraining(once), second = prepareTraining(twice);
    EXPECT_EQ(second.exactCopies, first.used);
    EXPECT_EQ(second.nearCopies, first.nearCopies);
    EXPECT_EQ(second.model.features, first.model.features);
    EXPECT_EQ(second.model.heights, first.model.heights);
    EXPECT_EQ(second.model.paf.mean, first.model.paf.mean);
}

/// The same scene in a file with fewer digits.
Scene rounded(Scene scene, double step)
{
    FeatureValues values = featureValues(scene.s);
    for (auto& value : values)
        if (value) value = std::round(*value / step) * step;
    scene.s = proprioception(values);
    for (auto& height : scene.truth) height = std::round(*height / step) * step;
    return scene;
}

TEST(SceneCopies, aCopyInAnotherNumberFormatIsLeftOut)
{
    const std::vector<Scene> once = scenesOf(20);
    const TrainingSet first = prepareTraining(once);
    for (const double step : {1e-12, 1e-6, 1e-3}) {
        std::vector<Scene> twice = once;
        for (const Scene& scene : once) twice.push_back(rounded(scene, step));
        const TrainingSet second = prepareTraining(twice);
        EXPECT_EQ(second.exactCopies, first.used) << step;
        EXPECT_EQ(second.model.features, first.model.features) << step;
    }
}

TEST(SceneCopies, aPosePressedTwiceCountsAsOnePlace)
{
    std::mt19937_64 rng(1);
    std::vector<Scene> scenes = scenesOf(20);
    const TrainingSet once = prepareTraining(scenes);
    const std::size_t different = scenes.size();
    for (std::size_t k = 0; k < different; k += 3)
        for (int n = 0; n < 4; ++n) scenes.push_back(again(scenes[k], rng));
    const auto copies = static_cast<int>(scenes.size() - different);
    const TrainingSet set = prepareTraining(scenes);
    EXPECT_GE(set.nearCopies - once.nearCopies, 95 * copies / 100);
    EXPECT_FALSE(set.runsWithCopies.empty());
    EXPECT_EQ(set.used, static_cast<int>(scenes.size()));
    const int distinct = set.used - set.nearCopies;
    EXPECT_EQ(set.model.scannedHeights.rows(), distinct);
    const std::vector<int> places = placesOf(set.model.features, set.model.heights);
    for (int u = 0; u < set.used; ++u) {
        const int place = places[static_cast<std::size_t>(u)];
        EXPECT_EQ(place == u, u < distinct) << u;
        EXPECT_LT(place, distinct) << u;
    }
}

TEST(SceneCopies, aSceneRepeatsTheFirstOneOfItsPlace)
{
    std::mt19937_64 rng(1);
    const Scene first = scenesOf(20)[3], second = again(first, rng);
    ASSERT_TRUE(isNearCopy(first, second));
    SceneRepeats<Scene> known;
    EXPECT_EQ(known.add(first, 5), (SceneRepeat{5, false}));
    EXPECT_EQ(known.add(second, 6), (SceneRepeat{5, false}));
    EXPECT_EQ(known.add(first, 7), (SceneRepeat{5, true}));
    Scene lacking = first;
    lacking.s.frontCurrent.reset();
    EXPECT_EQ(known.add(lacking, 8), (SceneRepeat{8, false}));
    lacking = first;
    lacking.truth.fill({});
    EXPECT_EQ(known.add(lacking, 9), (SceneRepeat{9, false}));
    SceneRepeats<TwoTrackScene> tracks;
    TwoTrackScene rolled = onBothSides(first);
    rolled.s.roll = 0.2;
    EXPECT_EQ(tracks.add(rolled, 0), (SceneRepeat{0, false}));
    EXPECT_EQ(tracks.add(mirrored(rolled), 1), (SceneRepeat{0, true}));
}

TEST(SceneCopies, holesAreComparedByTheirKnownBins)
{
    std::mt19937_64 rng(1);
    Scene first = scenesOf(20)[3];
    Scene second = again(first, rng);
    ASSERT_TRUE(isNearCopy(first, second));
    first.truth[2].reset();
    second.truth[2] = *second.truth[2] + 1.0;
    EXPECT_TRUE(isNearCopy(first, second)) << "bin 2 is known once only";
    second.truth[3] = *second.truth[3] + 0.5;
    EXPECT_FALSE(isNearCopy(first, second));
    second.truth.fill({});
    EXPECT_FALSE(isNearCopy(first, second)) << "no common bin";
    Scene holed = first;
    holed.truth[5].reset();
    const SceneCopies copies = withoutCopies({&first, &holed, &first});
    EXPECT_EQ(copies.exact, 1U) << "a scene with another hole is no exact copy";
    EXPECT_EQ(copies.repeats.size(), 1U);
}

/// Returns the share of true heights within the 80 % bands.
double coverage(const ModelData& model, const std::vector<Scene>& scenes)
{
    const Models models(model, absolem());
    Settings settings;
    settings.hazardRate = 0.0;
    settings.draws = 64;
    double held = 0.0;
    for (const Scene& scene : scenes) {
        const TerrainEstimate e = estimateTerrain(scene.s, {}, absolem(), models, settings);
        for (std::size_t i = 0; i < kBins; ++i)
            held += *scene.truth[i] >= e.q10[i] && *scene.truth[i] <= e.q90[i] ? 1.0 : 0.0;
    }
    return held / static_cast<double>(kBins * scenes.size());
}

ModelData trainedOn(const std::vector<Scene>& scenes)
{
    ModelData model = prepareTraining(scenes).model;
    for (BinModelData* data : {&model.pa, &model.paf})
        for (std::size_t i = 0; i < kBins; ++i)
            data->bins[i] = {Eigen::VectorXd::Constant(data->mean.size() - 1, 5.0),
                             data->sd[static_cast<Eigen::Index>(i)], 0.02};
    trainToyClearances(model);
    return model;
}

TEST(SceneCopies, bandsHoldTheTruthAsOftenAfterDoubling)
{
    const std::vector<Scene> once = scenesOf(24);
    const std::vector<Scene> unseen = someScenes(16, 99);
    const double whole = coverage(trainedOn(once), unseen);
    std::mt19937_64 rng(2);
    std::vector<Scene> twice = once, digits = once, fiveTimes = once;
    for (const Scene& scene : once) {
        twice.push_back(scene);
        digits.push_back(rounded(scene, 1e-4));
        for (int n = 0; n < 4; ++n) fiveTimes.push_back(again(scene, rng));
    }
    EXPECT_EQ(coverage(trainedOn(twice), unseen), whole);
    EXPECT_EQ(coverage(trainedOn(digits), unseen), whole);
    EXPECT_NEAR(coverage(trainedOn(fiveTimes), unseen), whole, 0.03);
}

TEST(SceneCopies, differentScenesAreKept)
{
    const std::vector<Scene> scenes = scenesOf(40);
    const TrainingSet set = prepareTraining(scenes);
    EXPECT_EQ(set.exactCopies, 0);
    EXPECT_LE(set.nearCopies, static_cast<int>(scenes.size() / 25));
}

TEST(SceneCopies, countsTheScenesAModelWasTrainedOn)
{
    const std::vector<Scene> scenes = scenesOf(20);
    const ModelData model = prepareTraining(scenes).model;
    EXPECT_EQ(trainingScenes(scenes, model), static_cast<std::size_t>(model.features.rows()));
    EXPECT_EQ(trainingScenes(someScenes(10, 6), model), 0U);
    std::vector<Scene> lacking = scenes;
    for (Scene& scene : lacking) scene.s.frontCurrent.reset();
    EXPECT_EQ(trainingScenes(lacking, model), 0U);
}

TEST(SceneCopies, countsTheScenesOfTwoTracksAModelWasTrainedOn)
{
    std::vector<TwoTrackScene> scenes = onBothSides(scenesOf(20));
    for (TwoTrackScene& scene : scenes) scene.s.roll = 0.1;
    const SideTrainingSet set = prepareSides(scenes);
    EXPECT_EQ(trainingScenes(scenes, set.rows), static_cast<std::size_t>(set.used));
    EXPECT_GT(set.used, 0);
    EXPECT_EQ(trainingScenes(onBothSides(someScenes(10, 6)), set.rows), 0U);
    for (TwoTrackScene& scene : scenes) scene.s.roll = 0.2;
    EXPECT_EQ(trainingScenes(scenes, set.rows), 0U) << "another roll is another scene";
}

/// The same scene with other noise of its sensors.
template <class SceneType>
SceneType readAgain(SceneType scene, std::mt19937_64& rng)
{
    scene.run = "other";
    scene.s = noisy(scene.s, {}, absolem().forceSaturation, rng);
    return scene;
}

TEST(SceneCopies, countsNearCopiesOfTrainingScenes)
{
    std::mt19937_64 rng(1);
    const std::vector<Scene> scenes = scenesOf(20);
    const ModelData model = prepareTraining(scenes).model;
    std::vector<Scene> copies;
    for (const Scene& scene : scenes) copies.push_back(readAgain(scene, rng));
    EXPECT_GE(trainingScenes(copies, model), 95 * copies.size() / 100);
    for (Scene& copy : copies) copy.truth[4] = *copy.truth[4] + 0.5;
    EXPECT_EQ(trainingScenes(copies, model), 0U) << "another ground is another scene";
}

TEST(SceneCopies, countsNearCopiesOfTrainingScenesOfTwoTracks)
{
    std::mt19937_64 rng(1);
    const std::vector<TwoTrackScene> scenes = onBothSides(scenesOf(20));
    const SideTrainingSet set = prepareSides(scenes);
    std::vector<TwoTrackScene> copies;
    for (const TwoTrackScene& scene : scenes) copies.push_back(readAgain(mirrored(scene), rng));
    EXPECT_GE(trainingScenes(copies, set.rows), 95 * copies.size() / 100);
    for (TwoTrackScene& copy : copies) copy.truth[1][4] = *copy.truth[1][4] + 0.5;
    EXPECT_EQ(trainingScenes(copies, set.rows), 0U) << "the other side is another ground";
}

TEST(SceneCopies, evenGroundMakesNoNearCopyOfATrainingScene)
{
    std::mt19937_64 rng(1);
    std::vector<Scene> scenes = scenesOf(20), even;
    for (std::size_t k = 0; k < scenes.size(); k += 2) {
        for (std::size_t i = 0; i < kBins; ++i) scenes[k].truth[i] = 0.02 * static_cast<double>(i);
        even.push_back(scenes[k]);
    }
    const ModelData model = prepareTraining(scenes).model;
    EXPECT_EQ(trainingScenes(even, model), even.size());
    for (Scene& scene : even) scene = readAgain(scene, rng);
    EXPECT_EQ(trainingScenes(even, model), 0U);
}

TEST(SceneCopies, recognisesScenesInAnotherNumberFormat)
{
    const std::vector<Scene> scenes = scenesOf(20);
    const ModelData model = prepareTraining(scenes).model;
    for (const double step : {1e-12, 1e-6, 1e-3}) {
        std::vector<Scene> rewritten = scenes;
        for (Scene& scene : rewritten) {
            FeatureValues values = featureValues(scene.s);
            for (auto& value : values)
                if (value) *value = std::round(*value / step) * step;
            scene.s = proprioception(values);
        }
        EXPECT_EQ(trainingScenes(rewritten, model), static_cast<std::size_t>(model.features.rows()))
            << step;
    }
}

}  // namespace
}  // namespace terratact
