#include "core/strip/carried_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "tests/support/absolem.h"
#include "tests/support/dead_reckoning.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

constexpr double kTenth = 1.2815515655446004;  // Φ⁻¹(0.9)

/// Heights on a line.
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

int binsOf(const CarriedEstimate& carried)
{
    return static_cast<int>(
        std::ranges::count_if(carried.bin, [](const auto& bin) { return bin.has_value(); }));
}

double widest(const CarriedEstimate& carried)
{
    double sd = 0.0;
    for (const auto& bin : carried.bin)
        if (bin) sd = std::max(sd, bin->sd);
    return sd;
}

TEST(CarriedEstimate, isTheEstimateItselfWhereNothingMoved)
{
    const TerrainEstimate e = stepEstimate();
    const CarriedEstimate carried = carriedEstimate(e, reckoned({{3.0, 0.1}, {3.0, 0.1}}).motion());
    for (std::size_t i = 0; i < kBins; ++i) {
        ASSERT_TRUE(carried.bin[i]) << i;
        EXPECT_EQ(carried.bin[i]->height, e.height[i]);
        EXPECT_EQ(carried.bin[i]->sd, e.sd[i]);
        EXPECT_NEAR(carried.bin[i]->q10, e.q10[i], 1e-15);
        EXPECT_NEAR(carried.bin[i]->q90, e.q90[i], 1e-15);
    }
}

TEST(CarriedEstimate, movesBackAsTheRobotMovesOn)
{
    const TerrainEstimate e = stepEstimate();
    const CarriedEstimate carried = carriedEstimate(e, {.forward = 0.2});
    ASSERT_EQ(binsOf(carried), kBins - 2) << "beyond the last bin nothing was estimated";
    for (std::size_t i = 0; i + 2 < kBins; ++i)
        EXPECT_NEAR(carried.bin[i]->height, e.height[i + 2], 1e-12);
    EXPECT_EQ(binsOf(carriedEstimate(e, {.forward = -0.25})), 8) << "what fell out behind is gone";
    EXPECT_EQ(binsOf(carriedEstimate(e, {.forward = 1.2})), 0);
    EXPECT_EQ(binsOf(carriedEstimate(e, {.forward = -1.2})), 0);
}

TEST(CarriedEstimate, ofARampIsThatRampBetweenTheBinsToo)
{
    const TerrainEstimate e = ramp(0.3);
    const CarriedEstimate carried = carriedEstimate(e, {.forward = 0.137, .up = 0.04});
    ASSERT_EQ(binsOf(carried), 9);
    for (int bin = 0; bin < 9; ++bin)
        EXPECT_NEAR(carried.bin[static_cast<std::size_t>(bin)]->height,
                    0.3 * (binCentre(bin) + 0.137) - 0.25 - 0.04, 1e-12);
}

TEST(CarriedEstimate, widensByItsFormula)
{
    const ImuMotion motion{.slipForward = 0.05, .slipUp = -0.01, .upSd = 0.02};
    const CarriedEstimate carried = carriedEstimate(ramp(0.3), motion);
    const double w = std::hypot(0.3 * 0.05 + 0.01, 0.02);
    EXPECT_NEAR(carried.bin[5]->sd, std::hypot(0.02, w), 1e-12);
    EXPECT_NEAR(carried.bin[5]->height - carried.bin[5]->q10, std::hypot(0.03, kTenth * w), 1e-12);
    EXPECT_NEAR(carried.bin[5]->q90 - carried.bin[5]->height, std::hypot(0.02, kTenth * w), 1e-12);
}

TEST(CarriedEstimate, hardlyWidensBySlipAlongItsSlope)
{
    const double pitch = std::atan(0.3);
    const auto onRamp = reckoned({{0.0, pitch}, {0.4, pitch}}).motion();
    const auto onLevel = reckoned({{0.0, 0.0}, {0.4, 0.0}}).motion();
    EXPECT_NEAR(carriedEstimate(ramp(0.3), onRamp).bin[3]->sd, std::hypot(0.02, 0.0087 * 0.4),
                1e-9);
    EXPECT_NEAR(carriedEstimate(ramp(0.3), onLevel).bin[3]->sd,
                std::hypot(0.02, 0.0087 * 0.4, 0.3 * 0.10 * 0.4), 1e-9);
}

TEST(CarriedEstimate, growsLessCertainForthAndBack)
{
    const TerrainEstimate e = ramp(0.3);
    double before = 0.0;
    for (const double way : {0.0, 0.1, 0.2, 0.4}) {
        const ImuMotion there = reckoned({{0.0, 0.0}, {way, 0.0}}).motion();
        const ImuMotion back = reckoned({{0.0, 0.0}, {way, 0.0}, {0.0, 0.0}}).motion();
        EXPECT_GE(widest(carriedEstimate(e, there)), before);
        EXPECT_NEAR(back.forward, 0.0, 1e-12);
        EXPECT_NEAR(back.way, 2.0 * way, 1e-12);
        EXPECT_GE(widest(carriedEstimate(e, back)), widest(carriedEstimate(e, there)));
        EXPECT_EQ(binsOf(carriedEstimate(e, back)), kBins);
        before = widest(carriedEstimate(e, there)) + 1e-6;
    }
}

TEST(CarriedEstimate, isFiniteWhereverItGoes)
{
    std::mt19937_64 rng(5);
    std::uniform_real_distribution<double> step(-0.2, 0.2);
    for (int walk = 0; walk < 200; ++walk) {
        DeadReckoning reckoning(absolem(), 0.0, 0.0);
        double travelled = 0.0;
        for (int k = 0; k < 10; ++k) {
            reckoning.add(travelled += step(rng), 3.0 * step(rng));
            for (const auto& bin : carriedEstimate(stepEstimate(), reckoning.motion()).bin) {
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
struct EstimateCarrierTest : testing::Test {
    Measurement m;
    TerrainEstimate estimate = stepEstimate();

    EstimateCarrierTest()
    {
        m.travelled = 5.0;
        m.turned = 3.1;
    }

    bool endsAfter(const std::function<void(Measurement&)>& change)
    {
        EstimateCarrier carrier(absolem(), estimate, m);
        Measurement next = m;
        next.time += 60.0;  // estimate and probe take time
        carrier.add(next);
        next.time += 0.05;
        change(next);
        carrier.add(next);
        return !carrier.carried();
    }
};

TEST_F(EstimateCarrierTest, followsTheTelemetry)
{
    EstimateCarrier carrier(absolem(), estimate, m);
    ASSERT_TRUE(carrier.carried());
    for (int k = 1; k <= 4; ++k) {
        m.time += 0.05;
        *m.travelled += 0.05;
        carrier.add(m);
        carrier.add(m);  // the same line again
    }
    ASSERT_TRUE(carrier.carried());
    EXPECT_NEAR(carrier.carried()->motion.forward, 0.2, 1e-12);
    EXPECT_NEAR(carrier.carried()->motion.way, 0.2, 1e-12);
    EXPECT_NEAR(carrier.carried()->bin[6]->height, estimate.height[8], 1e-12);
}

TEST_F(EstimateCarrierTest, endsBeyondItsLimits)
{
    EXPECT_FALSE(endsAfter([](Measurement&) {}));
    EXPECT_FALSE(endsAfter([](Measurement& n) { n.turned = 3.15 - 2.0 * std::numbers::pi; }))
        << "half a turn is where the number jumps";
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.travelled.reset(); }));
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.turned = 2.9; }));
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.pitch = 0.36; }));
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.roll = -0.36; }));
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.time += 1.1; }));
    EXPECT_TRUE(endsAfter([](Measurement& n) { *n.travelled -= 1.01; }));
    estimate.sd.fill(0.16);
    EXPECT_TRUE(endsAfter([](Measurement&) {})) << "it is too uncertain";
    m.travelled.reset();
    EXPECT_TRUE(endsAfter([](Measurement& n) { n.travelled = 1.0; })) << "the scene had no place";
}

TEST_F(EstimateCarrierTest, staysEndedWhenTheRobotComesBack)
{
    EstimateCarrier carrier(absolem(), estimate, m);
    Measurement gone = m;
    *gone.travelled += 1.1;
    carrier.add(gone);
    EXPECT_FALSE(carrier.carried());
    carrier.add(m);
    EXPECT_FALSE(carrier.carried());
}

}  // namespace
}  // namespace terratact
