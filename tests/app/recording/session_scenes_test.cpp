// Tests the heights that scenes of a session get, from its source or from what was touched.
#include "app/recording/session_scenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/absolem.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr SessionTime kSceneTime = 2'500'000'000;
constexpr double kReadHeight = -0.04;  // [m] of someEstimate(), bin 9

struct ScenesOfASession : testing::Test {
    /// Writes a session of `scene` and the same scene a second later. The first has two estimates, the second of which
    /// has a reading of the arm on that side.
    SessionReader session(SceneRow scene, ProbeSide side)
    {
        auto writer = SessionWriter::create(directory.file("drive.tts"), someStart());
        EXPECT_TRUE(writer);
        EXPECT_TRUE(
            writer->add(ModelRow{.id = 1, .name = "default.ttm", .hash = std::string(64, 'c')}));
        EXPECT_TRUE(writer->add(scene));
        EXPECT_TRUE(writer->add(someEstimate(1, kSceneTime + 1)));
        EstimateRow again = someEstimate(2, kSceneTime + 2);
        again.scene = 1;
        again.readings[0].side = side;
        EXPECT_TRUE(writer->add(again));
        scene.id = 2;
        scene.time += 1'000'000'000;
        EXPECT_TRUE(writer->add(scene));
        EXPECT_TRUE(writer->seal());
        return *SessionReader::open(directory.file("drive.tts"));
    }
    static SceneRow sceneWithoutTruth()
    {
        SceneRow scene = someScene(1, kSceneTime);
        scene.truth.reset();
        return scene;
    }
    TemporaryDirectory directory;
    RobotModel robot = absolem();
};

TEST_F(ScenesOfASession, haveTheHeightsOfTheSource)
{
    const SessionReader read = session(someScene(1, kSceneTime), ProbeSide::Middle);
    std::vector<Scene> scenes;
    addSessionScenes(read, {}, &robot, scenes);
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0].time, secondsOf(kSceneTime));
    EXPECT_EQ(scenes[0].run, scenes[1].run);
    EXPECT_EQ(scenes[0].truth[9], stepEstimate().height[9]) << "not the arm's";
    EXPECT_EQ(countKnownHeights(scenes[0]), static_cast<std::size_t>(kBins));
}

TEST_F(ScenesOfASession, withoutThoseThatAnEarlierFileHad)
{
    const SessionReader read = session(someScene(1, kSceneTime), ProbeSide::Middle);
    std::vector<Scene> scenes;
    addSessionScenes(read, {1}, nullptr, scenes);
    ASSERT_EQ(scenes.size(), 1U);
    EXPECT_EQ(scenes[0].time, secondsOf(kSceneTime + 1'000'000'000));
}

TEST_F(ScenesOfASession, haveTheHeightsThatTheArmTouchedLast)
{
    const SessionReader read = session(sceneWithoutTruth(), ProbeSide::Middle);
    std::vector<Scene> touched, unknown;
    addSessionScenes(read, {}, &robot, touched);
    addSessionScenes(read, {}, nullptr, unknown);
    ASSERT_EQ(touched.size(), 2U);
    ASSERT_EQ(unknown.size(), 2U);
    EXPECT_EQ(touched[0].truth[9], kReadHeight);
    EXPECT_NE(touched[1].truth[9], kReadHeight) << "this scene has no estimate";
    EXPECT_EQ(countKnownHeights(unknown[0]), 0U);
}

TEST_F(ScenesOfASession, haveTheArmsHeightOnItsSide)
{
    const SessionReader read = session(sceneWithoutTruth(), ProbeSide::Left);
    std::vector<TwoTrackScene> scenes;
    addSessionScenes(read, {}, &robot, scenes);
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0].truth[0][9], kReadHeight);
    EXPECT_NE(scenes[0].truth[1][9], kReadHeight);
}

TEST_F(ScenesOfASession, ofMeansHaveEqualSides)
{
    SceneRow scene = someScene(1, kSceneTime);
    scene.measurement.sides = {};
    const SessionReader read = session(scene, ProbeSide::Middle);
    std::vector<TwoTrackScene> scenes;
    addSessionScenes(read, {}, nullptr, scenes);
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0].truth[0], scenes[0].truth[1]);
    EXPECT_EQ(countKnownHeights(scenes[0]), static_cast<std::size_t>(2 * kBins));
}

}  // namespace
}  // namespace terratact
