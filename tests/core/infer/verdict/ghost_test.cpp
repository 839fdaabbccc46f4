#include "core/infer/verdict/ghost_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/support/absolem.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

constexpr double kTenth = 1.2815515655446004;  // Φ⁻¹(0.9)

/// Heights on a line; no bin is prior only.
TerrainEstimate ramp(double slope)
{
    TerrainEstimate e;
    for (std::size_t i = 0; i < kBins; ++i) {
        e.height[i] = e.mean[i] = slope * binCentre(static_cast<int>(i)) - 0.25;
        e.sd[i] = 0.02;
        e.q10[i] = e.height[i] - 0.03;
        e.q90[i] = e.height[i] + 0.02;
        e.ceiling[i] = 0.0;
    }
    return e;
}

DeadReckoning reckoned(std::initializer_list<std::pair<double, double>> way)
{
    DeadReckoning reckoning(absolem(), way.begin()->first, way.begin()->second);
    for (const auto& [travelled, pitch] : way) reckoning.add(travelled, pitch);
    return reckoning;
}

int binsOf(const Ghost& ghost)
{
    return static_cast<int>(
        std::ranges::count_if(ghost.bin, [](const auto& bin) { return bin.has_value(); }));
}

double widest(const Ghost& ghost)
{
    double sd = 0.0;
    for (const auto& bin : ghost.bin)
        if (bin) sd = std::max(sd, bin->sd);
    return sd;
}

TEST(Ghost, isTheEstimateItselfWhereNothingMoved)
{
    const TerrainEstimate e = stepEstimate();
    const Ghost ghost = ghostOf(e, reckoned({{3.0, 0.1}, {3.0, 0.1}}).motion());
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        ASSERT_EQ(ghost.bin[i].has_value(), !e.priorOnly(bin)) << "prior only was never estimated";
        if (!ghost.bin[i]) continue;
        EXPECT_EQ(ghost.bin[i]->height, e.height[i]);
        EXPECT_EQ(ghost.bin[i]->sd, e.sd[i]);
        EXPECT_NEAR(ghost.bin[i]->q10, e.q10[i], 1e-15);
        EXPECT_NEAR(ghost.bin[i]->q90, e.q90[i], 1e-15);
    }
}

TEST(Ghost, movesBackAsTheRobotMovesOn)
{
    const TerrainEstimate e = stepEstimate();
    const Ghost ghost = ghostOf(e, {.forward = 0.2});
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(ghost.bin[i]->height, e.height[i + 2], 1e-12);
    for (std::size_t i = 7; i < kBins; ++i)
        EXPECT_FALSE(ghost.bin[i]) << "prior only, or beyond it";
    EXPECT_EQ(binsOf(ghostOf(e, {.forward = -0.25})), 8) << "what fell out behind is gone";
    EXPECT_EQ(binsOf(ghostOf(e, {.forward = 1.2})), 0);
    EXPECT_EQ(binsOf(ghostOf(e, {.forward = -1.2})), 0);
}

TEST(Ghost, ofARampIsThatRampBetweenTheBinsToo)
{
    const TerrainEstimate e = ramp(0.3);
    const Ghost ghost = ghostOf(e, {.forward = 0.137, .up = 0.04});
    ASSERT_EQ(binsOf(ghost), 9);
    for (int bin = 0; bin < 9; ++bin)
        EXPECT_NEAR(ghost.bin[static_cast<std::size_t>(bin)]->height,
                    0.3 * (binCentre(bin) + 0.137) - 0.25 - 0.04, 1e-12);
}

TEST(Ghost, widensByItsFormula)
{
    const ImuMotion motion{.slipForward = 0.05, .slipUp = -0.01, .upSd = 0.02};
    const Ghost ghost = ghostOf(ramp(0.3), motion);
    const double w = std::hypot(0.3 * 0.05 + 0.01, 0.02);
    EXPECT_NEAR(ghost.bin[5]->sd, std::hypot(0.02, w), 1e-12);
    EXPECT_NEAR(ghost.bin[5]->height - ghost.bin[5]->q10, std::hypot(0.03, kTenth * w), 1e-12);
    EXPECT_NEAR(ghost.bin[5]->q90 - ghost.bin[5]->height, std::hypot(0.02, kTenth * w), 1e-12);
}

TEST(Ghost, hardlyWidensBySlipAlongItsSlope)
{
    const double pitch = std::atan(0.3);
    const auto onRamp = reckoned({{0.0, pitch}, {0.4, pitch}}).motion();
    const auto onLevel = reckoned({{0.0, 0.0}, {0.4, 0.0}}).motion();
    EXPECT_NEAR(ghostOf(ramp(0.3), onRamp).bin[3]->sd, std::hypot(0.02, 0.0087 * 0.4), 1e-9);
    EXPECT_NEAR(ghostOf(ramp(0.3), onLevel).bin[3]->sd,
                std::hypot(0.02, 0.0087 * 0.4, 0.3 * 0.10 * 0.4), 1e-9);
}

TEST(Ghost, growsLessCertainForthAndBack)
{
    const TerrainEstimate e = ramp(0.3);
    double before = 0.0;
    for (const double way : {0.0, 0.1, 0.2, 0.4}) {
        const ImuMotion there = reckoned({{0.0, 0.0}, {way, 0.0}}).motion();
        const ImuMotion back = reckoned({{0.0, 0.0}, {way, 0.0}, {0.0, 0.0}}).motion();
        EXPECT_GE(widest(ghostOf(e, there)), before);
        EXPECT_NEAR(back.forward, 0.0, 1e-12);
        EXPECT_NEAR(back.way, 2.0 * way, 1e-12);
        EXPECT_GE(widest(ghostOf(e, back)), widest(ghostOf(e, there)));
        EXPECT_EQ(binsOf(ghostOf(e, back)), kBins);
        before = widest(ghostOf(e, there)) + 1e-6;
    }
}

TEST(Ghost, isFiniteWhereverItGoes)
{
    std::mt19937_64 rng(5);
    std::uniform_real_distribution<double> step(-0.2, 0.2);
    for (int walk = 0; walk < 200; ++walk) {
        DeadReckoning reckoning(absolem(), 0.0, 0.0);
        double travelled = 0.0;
        for (int k = 0; k < 10; ++k) {
            reckoning.add(travelled += step(rng), 3.0 * step(rng));
            for (const auto& bin : ghostOf(stepEstimate(), reckoning.motion()).bin) {
                if (!bin) continue;
                ASSERT_TRUE(std::isfinite(bin->height) && std::isfinite(bin->sd));
                ASSERT_LE(bin->q10, bin->height);
                ASSERT_GE(bin->q90, bin->height);
                ASSERT_GE(bin->sd, 0.01 - 1e-12);
            }
        }
    }
}

/// A scene and the telemetry after it.
struct Track : testing::Test {
    Measurement m;
    TerrainEstimate estimate = stepEstimate();

    Track()
    {
        m.travelled = 5.0;
        m.turned = 3.1;
    }

    std::optional<NoGhost> after(const std::function<void(Measurement&)>& change)
    {
        GhostTrack track(absolem(), estimate, m);
        Measurement next = m;
        next.time += 60.0;  // estimate and probe take time
        track.add(next);
        next.time += 0.05;
        change(next);
        track.add(next);
        EXPECT_NE(track.ghost().has_value(), track.why().has_value());
        return track.why();
    }
};

TEST_F(Track, followsTheTelemetry)
{
    GhostTrack track(absolem(), estimate, m);
    ASSERT_TRUE(track.ghost());
    for (int k = 1; k <= 4; ++k) {
        m.time += 0.05;
        *m.travelled += 0.05;
        track.add(m);
        track.add(m);  // the same line again
    }
    ASSERT_TRUE(track.ghost());
    EXPECT_NEAR(track.ghost()->motion.forward, 0.2, 1e-12);
    EXPECT_NEAR(track.ghost()->motion.way, 0.2, 1e-12);
    EXPECT_NEAR(track.ghost()->bin[6]->height, estimate.height[8], 1e-12);
}

TEST_F(Track, endsWithAReasonBeyondItsLimits)
{
    EXPECT_EQ(after([](Measurement&) {}), std::nullopt);
    EXPECT_EQ(after([](Measurement& n) { n.turned = 3.15 - 2.0 * std::numbers::pi; }), std::nullopt)
        << "half a turn is where the number jumps";
    EXPECT_EQ(after([](Measurement& n) { n.travelled.reset(); }), NoGhost::NoOdometry);
    EXPECT_EQ(after([](Measurement& n) { n.turned = 2.9; }), NoGhost::Turned);
    EXPECT_EQ(after([](Measurement& n) { n.pitch = 0.36; }), NoGhost::Tilted);
    EXPECT_EQ(after([](Measurement& n) { n.roll = -0.36; }), NoGhost::Tilted);
    EXPECT_EQ(after([](Measurement& n) { n.time += 1.1; }), NoGhost::TelemetryGap);
    EXPECT_EQ(after([](Measurement& n) { *n.travelled -= 1.01; }), NoGhost::TooFar);
    EXPECT_EQ(after([](Measurement& n) { *n.travelled += 0.95; }), NoGhost::NothingLeft);
    estimate.sd.fill(0.16);
    EXPECT_EQ(after([](Measurement&) {}), NoGhost::TooUncertain);
    m.travelled.reset();
    EXPECT_EQ(after([](Measurement& n) { n.travelled = 1.0; }), NoGhost::NoOdometry);
    std::set<std::string> words;
    for (const NoGhost why :
         {NoGhost::NoOdometry, NoGhost::TooFar, NoGhost::TooUncertain, NoGhost::Tilted,
          NoGhost::Turned, NoGhost::TelemetryGap, NoGhost::NothingLeft})
        EXPECT_TRUE(words.insert(describe(why).english).second);
}

TEST_F(Track, staysEndedWhenTheRobotComesBack)
{
    GhostTrack track(absolem(), estimate, m);
    Measurement gone = m;
    *gone.travelled += 1.1;
    track.add(gone);
    EXPECT_FALSE(track.ghost());
    track.add(m);
    EXPECT_FALSE(track.ghost());
    EXPECT_EQ(track.why(), NoGhost::TooFar);
}

}  // namespace
}  // namespace terratact
