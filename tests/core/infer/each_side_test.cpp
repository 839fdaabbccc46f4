#include "core/infer/each_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/side_plane.h"
#include "core/terrain/ground_lines.h"
#include "tests/support/toy_model.h"
#include "tests/support/toy_sides.h"

namespace terratact {
namespace {

const Models& planeModels()
{
    static const ModelData model = toyModel(12);
    static const Models models(model, absolem());
    return models;
}

constexpr Settings kOf{.hazardRate = 0.0};

TwoTrackReadings rolledReadings()
{
    static const std::vector<TwoTrackScene> scenes = someTrackScenes(4, 9);
    return std::ranges::find_if(scenes,
                                [](const auto& scene) { return std::abs(scene.s.roll) > 0.08; })
        ->s;
}

TEST(EachSide, withoutRollItIsThePlaneOfThatSide)
{
    TwoTrackReadings s = rolledReadings();
    s.roll = 0.0;
    const TwoTrackEstimate estimate = estimateEachSide(s, {}, absolem(), planeModels(), kOf);
    EXPECT_EQ(estimate.side[0],
              estimateTerrain(sideReadings(s, Side::Left), {}, absolem(), planeModels(), kOf));
    EXPECT_NE(estimate.side[0].draws, estimate.side[1].draws);
    EXPECT_EQ(estimate.side[1].settings.seed, kOf.seed);
    EXPECT_FALSE(estimate.onePlane);
}

TEST(EachSide, rollLiftsEachBinByItsLine)
{
    TwoTrackReadings s = rolledReadings();
    s.roll = 0.0;
    const TwoTrackEstimate level = estimateEachSide(s, {}, absolem(), planeModels(), kOf);
    s.roll = 0.1;
    const TwoTrackEstimate rolled = estimateEachSide(s, {}, absolem(), planeModels(), kOf);
    for (std::size_t i = 0; i < kBins; ++i) {
        const double y = i < std::size_t{kFirstFlipperBin} ? absolem().lateral.trackY
                                                           : absolem().lateral.flipperY;
        EXPECT_NEAR(rolled.side[0].mean[i] - level.side[0].mean[i], y * std::sin(0.1), 1e-12);
        EXPECT_NEAR(rolled.side[1].q90[i] - level.side[1].q90[i], -y * std::sin(0.1), 1e-12);
        EXPECT_NEAR(rolled.side[0].draws[3][i] - level.side[0].draws[3][i], y * std::sin(0.1),
                    1e-12);
    }
}

TEST(EachSide, anArmReadingMovesItsSideAlone)
{
    const TwoTrackReadings s = rolledReadings();
    const TwoTrackEstimate before = estimateEachSide(s, {}, absolem(), planeModels(), kOf);
    const std::vector<ArmReading> arm{
        {.bin = 9, .height = before.side[1].mean[9] + 0.1, .sd = 0.005}};
    const TwoTrackEstimate after =
        estimateEachSide(s, {std::span<const ArmReading>{}, arm}, absolem(), planeModels(), kOf);
    EXPECT_EQ(after.side[0], before.side[0]);
    EXPECT_NEAR(after.side[1].mean[9], arm[0].height, 0.02);
    EXPECT_EQ(after.side[1].origin[9], Origin::Arm);
}

TEST(EachSide, samplesByAMethodThatHasLearntOnePlane)
{
    Settings settings = kOf;
    settings.method = Method::Pafc;
    settings.draws = 4000;
    settings.seed = 3;
    const TwoTrackReadings s = rolledReadings();
    const TwoTrackEstimate estimate = estimateEachSide(s, {}, absolem(), planeModels(), settings);
    const std::size_t at = s.roll > 0.0 ? 0 : 1;
    EXPECT_GT(estimate.side[at].mean[3], estimate.side[1 - at].mean[3]);
    EXPECT_EQ(estimate.side[0].settings.method, Method::Pafc);
    EXPECT_EQ(estimate.side[0].draws.size(), estimate.side[1].draws.size());
}

}  // namespace
}  // namespace terratact
