#include "core/learn/data/two_track_scene_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/learn/data/scene_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TwoTrackScene someScene()
{
    TwoTrackScene scene;
    scene.run = "7";
    scene.time = 1.5;
    scene.s.pitch = 0.1;
    scene.s.roll = -0.2;
    scene.s.flippers = {0.1, 0.2, 0.3, 0.4};
    scene.s.currents = {1.0, 2.0, std::nullopt, 4.0};
    for (std::size_t e = 0; e < kForceElements; ++e) {
        scene.s.forces[0][e] = 1.0 + static_cast<double>(e);
        if (e != 3) scene.s.forces[1][e] = 2.0 + static_cast<double>(e);
    }
    scene.truth[0][0] = -0.25;
    scene.truth[1][10] = 0.125;
    return scene;
}

struct TwoTrackSceneFileTest : testing::Test {
    Result<TwoTrackSceneFile> read(const std::string& content)
    {
        return readTwoTrackScenes(dir.write("scenes.csv", content));
    }
    TemporaryDirectory dir;
};

TEST_F(TwoTrackSceneFileTest, readsWhatItWrote)
{
    const TwoTrackScene plain = someScene();
    TwoTrackScene full = plain;
    full.s.differential = 0.05;
    full.s.forces[2][0] = 3.5;
    for (const auto& scenes : {std::vector{plain}, std::vector{plain, full}}) {
        const std::string text = twoTrackScenesText(scenes);
        const auto file = read(text);
        ASSERT_TRUE(file) << file.error().text;
        EXPECT_EQ(file->scenes, scenes);
        EXPECT_TRUE(file->notices.empty());
        EXPECT_EQ(text.find("differential_rad") != std::string::npos, scenes.size() == 2);
        EXPECT_EQ(text.find("rear_left_force_1_n") != std::string::npos, scenes.size() == 2);
        EXPECT_EQ(text.find("rear_left_force_2_n"), std::string::npos);
    }
}

TEST_F(TwoTrackSceneFileTest, readsScenesOfOnePlaneAsEqualSides)
{
    Scene plane;
    plane.run = "1";
    plane.time = 0.5;
    plane.s.pitch = 0.1;
    plane.s.front = 0.2;
    plane.s.rear = 0.3;
    plane.s.rearCurrent = 1.0;
    plane.s.force[5] = 7.0;
    plane.truth[4] = -0.2;
    const auto file = read(scenesText({plane}));
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->scenes.size(), 1U);
    const TwoTrackScene& both = file->scenes[0];
    EXPECT_EQ(both, onBothSides(plane));
    EXPECT_EQ(both.s.roll, 0.0);
    EXPECT_EQ(both.s.flippers, (PerFlipper<double>{0.2, 0.2, 0.3, 0.3}));
    EXPECT_EQ(both.s.currents[3], 1.0);
    EXPECT_EQ(both.s.forces[1][5], 7.0);
    EXPECT_EQ(both.truth[1], plane.truth);
    EXPECT_EQ(mirrored(both), both);
}

TEST_F(TwoTrackSceneFileTest, mirroredExchangesReadingsAndTruth)
{
    const TwoTrackScene mirror = mirrored(someScene());
    EXPECT_EQ(mirror.s.roll, 0.2);
    EXPECT_EQ(mirror.s.flippers[0], 0.2);
    EXPECT_EQ(mirror.truth[1][0], -0.25);
    EXPECT_EQ(mirrored(mirror), someScene());
}

TEST_F(TwoTrackSceneFileTest, refusesWhatCannotBe)
{
    const std::string text = twoTrackScenesText({someScene()});
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string copy = text;
        const std::size_t at = copy.find(from);
        if (at == std::string::npos) throw std::invalid_argument("no " + from);
        return copy.replace(at, from.size(), to);
    };
    const std::string path = dir.file("scenes.csv");
    EXPECT_TRUE(refused(read(changed("rear_right_current_a", "x")), path,
                        {"the column rear_right_current_a is missing; not known: 'x'"}));
    EXPECT_TRUE(refused(read(text.substr(text.find('\n') + 1)), path,
                        {"line 1", "holds numbers, expected the names of the columns"}));
    EXPECT_TRUE(refused(read(changed("left_h_-0.3_m", "left_h_-0.35_m")), path,
                        {"'left_h_-0.35_m' is not a height column", "right_h_+0.7_m"}));
    EXPECT_TRUE(refused(read(changed("left_h_-0.3_m", "h_-0.3_m")), path, {"not a height column"}));
    EXPECT_TRUE(refused(read(changed("-0.2,0.1", "-11.5,0.1")), path,
                        {"line 2", "roll_rad is -11.5", "is it in degrees?"}));
    EXPECT_TRUE(refused(read(changed("-0.2,0.1", ",0.1")), path, {"line 2", "roll_rad"}));
    TwoTrackScene wrong = someScene();
    wrong.s.roll = 7.0;
    EXPECT_THROW((void)twoTrackScenesText({wrong}), std::invalid_argument);
}

TEST_F(TwoTrackSceneFileTest, keepsTheSdOfBothSides)
{
    TwoTrackScene scene = someScene();
    EXPECT_EQ(twoTrackScenesText({scene}).find("_sd_"), std::string::npos);
    scene.truthSd[0][2] = 0.01;
    scene.truthSd[1][10] = 0.02;
    const auto file = read(twoTrackScenesText({scene}));
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->scenes.at(0), scene);
    EXPECT_EQ(mirrored(scene).truthSd[1][2], 0.01);
    Scene plane;
    plane.truthSd[4] = 0.03;
    EXPECT_EQ(onBothSides(plane).truthSd[1][4], 0.03);
}

}  // namespace
}  // namespace terratact
