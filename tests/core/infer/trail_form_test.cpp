#include "core/infer/trail_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "core/base/message.h"
#include "core/infer/two_track_estimator.h"
#include "tests/support/toy_model.h"
#include "tests/support/toy_sides.h"

namespace terratact {
namespace {

constexpr std::size_t kProbedBin = 9, kDeadElement = 3;

/// Models of a plane and of both sides, without networks.
const Models& modelsWithoutNetworks()
{
    static const ModelData data = [] {
        ModelData model = toyModel(12);
        model.sides = toySides();
        return model;
    }();
    static const Models models(data, absolem());
    return models;
}

Settings byTrailWithoutHazards()
{
    Settings settings;
    settings.method = Method::Trail;
    settings.hazardRate = 0.0;
    return settings;
}

/// Returns a history of 0.5 m. On the way the arm measured this height [m], and the flippers felt the bin.
TrailHistory probedEarlier(double height, std::size_t bin = kProbedBin)
{
    TrailHistory history = emptyHistory(0.0, 0.0);
    history.way = 0.5;
    for (TrailGround& ground : history.ground) {
        ground.armHeight[bin] = height;
        ground.armSd[bin] = 0.015;
        ground.felt[bin] = kAllCells;
    }
    return history;
}

bool says(const TerrainEstimate& estimate, const std::string& words)
{
    return english(estimate.warnings, "; ").find(words) != std::string::npos;
}

void expectProbed(const TerrainEstimate& after, const TerrainEstimate& before, double height)
{
    EXPECT_NEAR(after.height[kProbedBin], height, 0.03);
    EXPECT_LT(after.sd[kProbedBin], before.sd[kProbedBin]);
    EXPECT_EQ(after.origin[kProbedBin], Origin::Sampled) << "this scene did not measure it";
    EXPECT_NE(after.touch[kProbedBin], Touch::Remembered) << "its height is not known";
}

TEST(TrailForm, aDeadElementKeepsTheArmsReading)
{
    Proprioception s = someScenes(4, 77).front().s;
    const auto estimate = [&s](const TrailHistory* history) {
        return estimateTerrain(s, {}, absolem(), modelsWithoutNetworks(), byTrailWithoutHazards(),
                               {}, history);
    };
    for (const bool isDead : {false, true}) {
        if (isDead) s.force[kDeadElement].reset();
        const TerrainEstimate before = estimate(nullptr);
        const double height = before.height[kProbedBin] - 0.05;
        const TrailHistory history = probedEarlier(height);
        const TerrainEstimate after = estimate(&history);
        expectProbed(after, before, height);
        EXPECT_TRUE(says(after, "only the arm's earlier readings are used"));
        EXPECT_FALSE(says(before, "earlier readings")) << "there are none";
        EXPECT_TRUE(says(before, "this scene alone counts"));
        EXPECT_EQ(says(before, "nothing of the way is remembered"), !isDead);
        EXPECT_EQ(isForgotten(after), !isDead);
    }
}

TEST(TrailForm, aDeadElementKeepsTheReadingOfItsSide)
{
    TwoTrackReadings s = someTrackScenes(4, 9).front().s;
    s.forces[indexOf(Flipper::FrontLeft)][kDeadElement].reset();
    const auto estimate = [&s](const TrailHistory* history) {
        return estimateByBothSides(s, {}, absolem(), modelsWithoutNetworks(),
                                   byTrailWithoutHazards(), {}, history);
    };
    const TwoTrackEstimate before = estimate(nullptr);
    const double height = before.side[0].height[kProbedBin] - 0.05;
    TrailHistory history = probedEarlier(height);
    history.ground[2].armSd = {};
    const TwoTrackEstimate after = estimate(&history);
    expectProbed(after.side[0], before.side[0], height);
    const auto moved = [&](std::size_t side) {
        return std::abs(after.side.at(side).height[kProbedBin]
                        - before.side.at(side).height[kProbedBin]);
    };
    EXPECT_LT(moved(1), moved(0)) << "the right side was not probed";
    EXPECT_TRUE(says(after.side[0], "only the arm's earlier readings are used"));
    for (const TerrainEstimate* side : {&before.side[0], &before.side[1], &after.side[1]})
        EXPECT_FALSE(says(*side, "earlier readings"));
}

TEST(TrailForm, aContactStaysWhereTheArmMeasuredEarlier)
{
    int contacts = 0;
    for (const Scene& scene : someScenes(20, 77)) {
        const auto estimate = [&scene](const TrailHistory* history) {
            return estimateTerrain(scene.s, {}, absolem(), modelsWithoutNetworks(),
                                   byTrailWithoutHazards(), {}, history);
        };
        const TerrainEstimate before = estimate(nullptr);
        for (std::size_t i = 0; i < kBins; ++i) {
            if (before.origin[i] != Origin::Contact) continue;
            ++contacts;
            const TrailHistory history = probedEarlier(before.height[i] - 0.1, i);
            const TerrainEstimate after = estimate(&history);
            EXPECT_EQ(after.origin[i], Origin::Contact);
            EXPECT_EQ(after.height[i], before.height[i]);
            EXPECT_FALSE(says(after, "earlier readings")) << "the only one is not used";
        }
    }
    EXPECT_GT(contacts, 0);
}

TEST(TrailForm, localAloneUsesNoMemory)
{
    const Proprioception s = someScenes(4, 77).front().s;
    const TrailHistory history = probedEarlier(-0.6);
    Settings settings;
    const TerrainEstimate with =
        estimateTerrain(s, {}, absolem(), modelsWithoutNetworks(), settings, {}, &history);
    EXPECT_EQ(with, estimateTerrain(s, {}, absolem(), modelsWithoutNetworks(), settings));
}

}  // namespace
}  // namespace terratact
