#include "app/modelling/simulation/simulated_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/modelling/simulation/hazard_scenes.h"
#include "core/learn/data/profile_file.h"
#include "core/sim/drive.h"
#include "core/store/file_group.h"
#include "tests/support/absolem.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

SimulatedScenes fewStopsOver(const std::string& terrain, int count)
{
    SimulatedScenes options;
    options.terrain = terrain;
    options.count = count;
    options.seed = 5;
    return options;
}

template <class AnyScene>
std::size_t stopsOf(const DrivenScenes<AnyScene>& driven)
{
    return driven.scenes.size() + static_cast<std::size_t>(driven.skipped);
}

/// Returns the largest difference of two true heights of a scene [m].
double heightSpread(const std::vector<Scene>& scenes)
{
    double largest = 0.0;
    for (const Scene& scene : scenes) {
        const auto [lowest, highest] = std::ranges::minmax(knownHeights(scene.truth));
        largest = std::max(largest, highest - lowest);
    }
    return largest;
}

TEST(SimulatedScenes, ofAPresetAreAsManyStopsAsWanted)
{
    for (const char* preset : {"boxes", "varied", "hazards"}) {
        const auto plane = simulateScenes(absolem(), fewStopsOver(preset, 5));
        const auto tracks = simulateTrackScenes(absolem(), fewStopsOver(preset, 5));
        ASSERT_TRUE(plane && tracks) << preset;
        EXPECT_EQ(stopsOf(*plane), 5U) << preset;
        EXPECT_EQ(stopsOf(*tracks), 5U) << preset;
        EXPECT_FALSE(plane->map.isWanted()) << preset;
    }
}

TEST(SimulatedScenes, dependOnTheSeedAlone)
{
    SimulatedScenes options = fewStopsOver("varied", 4);
    const auto some = simulateScenes(absolem(), options);
    const auto same = simulateScenes(absolem(), options);
    options.seed = 6;
    const auto others = simulateScenes(absolem(), options);
    ASSERT_TRUE(some && same && others);
    EXPECT_TRUE(some->scenes == same->scenes);
    EXPECT_FALSE(some->scenes == others->scenes);
}

/// Two level profiles of 4 m.
struct ScenesOverAFile : testing::Test {
    ScenesOverAFile() { options.step = 1.0; }
    std::vector<Scene> scenes() const
    {
        const auto driven = simulateScenes(absolem(), options);
        EXPECT_TRUE(driven) << driven.error().text;
        return driven ? driven->scenes : std::vector<Scene>();
    }
    TemporaryDirectory directory;
    SimulatedScenes options =
        fewStopsOver(directory.write("profiles.csv", "0,0,0,0,0\n1,1,1,1,1\n"), 0);
};

TEST_F(ScenesOverAFile, areAtEveryStopOrAtSomeInOrder)
{
    const auto file = readProfiles(options.terrain, options.step, options.blocks);
    ASSERT_TRUE(file) << file.error().text;
    const auto all = simulateScenes(absolem(), options);
    options.count = 7;
    const auto some = simulateScenes(absolem(), options);
    ASSERT_TRUE(all && some);
    EXPECT_EQ(stopsOf(*all), 2 * stopsOver(file->profiles[0], 0.1).size());
    EXPECT_EQ(stopsOf(*some), 7U);
    EXPECT_EQ(all->scenes.front().run, "1");
    EXPECT_EQ(all->scenes.back().run, "2");
    std::vector<std::pair<std::string, double>> places;
    for (const Scene& scene : some->scenes) places.emplace_back(scene.run, scene.time);
    EXPECT_EQ(std::ranges::adjacent_find(places, std::greater_equal<>()), places.end());
}

TEST_F(ScenesOverAFile, haveTheScannersNoiseUnlessExact)
{
    EXPECT_GT(heightSpread(scenes()), 1e-3);
    options.exactTruth = true;
    EXPECT_LT(heightSpread(scenes()), 1e-9) << "the ground is level";
}

TEST_F(ScenesOverAFile, getTheFaultOfASensorFromTheStart)
{
    options.sensorFault = sensorFaultFrom("stuck:pitch");
    ASSERT_TRUE(options.sensorFault);
    const std::vector<Scene> stuck = scenes();
    ASSERT_FALSE(stuck.empty());
    for (const Scene& scene : stuck) {
        if (scene.run != "1") continue;
        EXPECT_EQ(scene.s.pitch, stuck[0].s.pitch);
    }
    EXPECT_THROW((void)simulateTrackScenes(absolem(), options), std::invalid_argument);
}

TEST_F(ScenesOverAFile, getTheDisturbance)
{
    options.disturbance = Disturbance::DeadElement;
    const std::vector<Scene> dead = scenes();
    ASSERT_FALSE(dead.empty());
    for (const Scene& scene : dead) EXPECT_EQ(scene.s.force[3], 0.0);
}

TEST_F(ScenesOverAFile, areLaidOutInTheMap)
{
    options.count = 2;
    options.map.cloud = directory.file("map.pcd");
    options.map.poses = directory.file("poses.csv");
    const auto driven = simulateScenes(absolem(), options);
    ASSERT_TRUE(driven);
    FileGroup files;
    const auto points = driven->map.write(absolem(), files);
    ASSERT_TRUE(points) << points.error().text;
    ASSERT_TRUE(files.commit());
    EXPECT_GT(*points, 0U);
    EXPECT_EQ(std::ranges::count(contentOf(options.map.poses), '\n'),
              static_cast<std::ptrdiff_t>(driven->scenes.size()) + 1);
}

TEST_F(ScenesOverAFile, ofOnePlaneAreEqualLeftAndRight)
{
    options.exactTruth = true;
    const auto driven = simulateTrackScenes(absolem(), options);
    ASSERT_TRUE(driven && !driven->scenes.empty());
    for (const TwoTrackScene& scene : driven->scenes) {
        EXPECT_EQ(scene.truth[0], scene.truth[1]);
        EXPECT_NE(scene.s.flippers[0], scene.s.flippers[1]) << "each sensor has its own noise";
    }
}

TEST_F(ScenesOverAFile, needTheFile)
{
    options.terrain = directory.file("absent.csv");
    EXPECT_TRUE(refused(simulateScenes(absolem(), options), options.terrain, {}));
    EXPECT_TRUE(refused(simulateTrackScenes(absolem(), options), options.terrain, {}));
}

}  // namespace
}  // namespace terratact
