#include "core/infer/estimate/hazards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
