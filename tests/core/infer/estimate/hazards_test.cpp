#include "core/infer/estimate/hazards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

/// 2000 flat draws; the bins ahead are felt, bounded, bounded, open, open.
TerrainEstimate flatEstimate()
{
    TerrainEstimate e;
    e.draws.assign(2000, Heights{});
    e.ess.fill(2000.0);
    e.touch = {Touch::Bounded, Touch::Felt,    Touch::Felt,   Touch::Felt,
               Touch::Felt,    Touch::Felt,    Touch::Felt,   Touch::Bounded,
               Touch::Bounded, Touch::NotFelt, Touch::NotFelt};
    e.ceiling.fill(0.0);
    e.ceiling[9] = e.ceiling[10] = std::numeric_limits<double>::infinity();
    return e;
}

TEST(Hazards, leaveFeltBinsAndTheBodyAlone)
{
    const TerrainEstimate before = flatEstimate();
    TerrainEstimate e = before;
    addHazards(e, 0.05);
    for (std::size_t i = 0; i <= 6; ++i) {
        EXPECT_EQ(e.sd[i], before.sd[i]);
        for (const Heights& draw : e.draws) ASSERT_EQ(draw[i], 0.0);
    }
    EXPECT_EQ(e.height, before.height);
}

TEST(Hazards, beginInTheStatedShareOfDraws)
{
    TerrainEstimate e = flatEstimate();
    addHazards(e, 0.05);
    int begun = 0;
    for (const Heights& draw : e.draws) begun += draw[7] != 0.0 ? 1 : 0;
    EXPECT_EQ(begun, 100);
    EXPECT_GT(e.sd[7], 0.05);
    EXPECT_GE(stepProbabilities(e, 0.1)[6].p, 0.05);
    EXPECT_GE(stepProbabilities(e, 1.9)[6].p, 0.05);  // whatever the limit
}

TEST(Hazards, boundedBinsStayBelowTheirCeiling)
{
    TerrainEstimate e = flatEstimate();
    addHazards(e, 0.5);
    double highest = -1.0, deepest = 1.0;
    for (const Heights& draw : e.draws) {
        ASSERT_LE(draw[7], 0.0);
        ASSERT_LE(draw[8], 0.0);
        highest = std::max(highest, draw[9]);
        deepest = std::min(deepest, draw[7]);
    }
    EXPECT_GT(highest, kSmallestHazard);  // a wall may stand where nothing covers the ground
    EXPECT_LT(deepest, -kSmallestHazard);
}

/// Probability of a hazard where the model expects N(0, 0.02²) and the arm reads `offset` ± 0.03 m.
double probabilityOf(double offset, bool isCovered, double rate)
{
    const double variance = 0.02 * 0.02 + 0.03 * 0.03;
    const double logDensity =
        -0.5 * (offset * offset / variance + std::log(2.0 * std::numbers::pi * variance));
    return hazardProbability(offset, 0.03, logDensity, isCovered, rate);
}

TEST(Hazards, aFarReadingIndicatesAHazard)
{
    EXPECT_LT(probabilityOf(0.03, false, 0.05), 0.001);
    EXPECT_GT(probabilityOf(-0.3, false, 0.05), 0.999);
    EXPECT_GT(probabilityOf(0.3, false, 0.05), 0.999);
    EXPECT_GT(probabilityOf(-3.0, false, 0.05), 0.999) << "deeper than the model of hazards";
    EXPECT_GT(probabilityOf(-0.3, false, 0.0), 0.99) << "at any rate";
    EXPECT_EQ(probabilityOf(0.3, true, 0.05), 0.0) << "no wall stands within the robot";
    EXPECT_GT(probabilityOf(-0.12, true, 0.05), probabilityOf(-0.12, false, 0.05));
    EXPECT_GT(probabilityOf(-0.12, false, 0.05), probabilityOf(-0.12, false, 0.01));
}

TEST(Hazards, aMeasuredDropStaysAndContinuesAhead)
{
    TerrainEstimate e = flatEstimate();
    e.touch[9] = Touch::FeltInPart;
    const std::array drop{MeasuredHazard{9, -0.5, 0.01, -0.5, 1.0}};
    addMeasuredHazards(e, drop);
    EXPECT_NEAR(e.height[9], -0.5, 0.01);
    EXPECT_NEAR(e.sd[9], 0.01, 0.002);
    EXPECT_NEAR(e.height[10], -0.5, 0.01) << "not felt: it lies as deep";
    EXPECT_EQ(e.height[8], 0.0);
    EXPECT_EQ(stepProbabilities(e, 0.1)[8].p, 1.0);
    TerrainEstimate half = flatEstimate();
    const std::array readings{MeasuredHazard{9, -0.5, 0.01, -0.5, 0.5},
                              MeasuredHazard{10, 0.0, 0.01, 0.0, 0.0}};
    addMeasuredHazards(half, readings);
    const auto low =
        std::ranges::count_if(half.draws, [](const Heights& h) { return h[9] < -0.4; });
    EXPECT_EQ(low, 1000);
    EXPECT_EQ(half.height[10], 0.0) << "the arm measured it, too";
    TerrainEstimate none = flatEstimate();
    addMeasuredHazards(none, std::array{MeasuredHazard{9, -0.5, 0.01, -0.5, 0.0002}});
    EXPECT_EQ(none, flatEstimate()) << "less than half a draw";
}

TEST(Hazards, areTheSameForTheSameSeed)
{
    TerrainEstimate a = flatEstimate(), b = flatEstimate(), c = flatEstimate();
    c.settings.seed = 7;
    for (TerrainEstimate* e : {&a, &b, &c}) addHazards(*e, 0.05);
    EXPECT_EQ(a, b);
    EXPECT_NE(a.draws, c.draws);
}

TEST(Hazards, rateZeroChangesNothing)
{
    TerrainEstimate e = flatEstimate();
    addHazards(e, 0.0);
    EXPECT_EQ(e, flatEstimate());
    EXPECT_THROW(addHazards(e, -0.1), std::invalid_argument);
    EXPECT_THROW(addHazards(e, std::nan("")), std::invalid_argument);
}

TEST(Hazards, unfeltStepRateCountsBinsAhead)
{
    TerrainEstimate e = flatEstimate();
    e.settings.hazardRate = 0.1;
    EXPECT_DOUBLE_EQ(unfeltStepRate(e, 0, 6), 0.0);
    EXPECT_NEAR(unfeltStepRate(e, 6, 8), 0.19, 1e-12);
    e.touch[6] = Touch::FeltInPart;
    EXPECT_NEAR(unfeltStepRate(e, 6, 8), 0.271, 1e-12);
    e.touch = unrecordedTouch();
    EXPECT_DOUBLE_EQ(unfeltStepRate(e, 0, 10), 0.0);
}

}  // namespace
}  // namespace terratact
