// Tests that a large file of scenes is estimated in parts.
#include "app/modelling/scene_estimates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/learn/data/scene.h"

namespace terratact {
namespace {

TEST(SceneParts, holdEverySceneOnceInOrder)
{
    std::vector<Scene> scenes(1001);
    for (std::size_t k = 0; k < scenes.size(); ++k) scenes[k].time = static_cast<double>(k);
    std::size_t seen = 0, largest = 0;
    forParts(scenes, [&](std::size_t first, std::span<const Scene> part) {
        EXPECT_EQ(first, seen);
        for (const Scene& scene : part) EXPECT_EQ(scene.time, static_cast<double>(seen++));
        largest = std::max(largest, part.size());
    });
    EXPECT_EQ(seen, scenes.size());
    EXPECT_LE(largest, std::max<std::size_t>(32, 4 * static_cast<std::size_t>(processors())))
        << "the draws of a part are in memory at once";
}

TEST(SceneParts, ofNoSceneAreNone)
{
    forParts(std::vector<Scene>(), [](std::size_t, std::span<const Scene>) { FAIL(); });
}

}  // namespace
}  // namespace terratact
