// Tests the error of an estimate against known heights.
#include "app/modelling/scene_error.h"

#include <gtest/gtest.h>

#include "tests/support/estimates.h"

namespace terratact {
namespace {

TEST(SceneError, isOfKnownHeightsAlone)
{
    const TwoTrackEstimate estimate = equalSides(stepEstimate());  // −0.25 m, from bin 8 on −0.05 m
    std::array<OptionalHeights, 2> truth{};
    EXPECT_FALSE(sceneError(estimate, truth));
    EXPECT_EQ(knownHeights(truth), 0);
    truth[0][0] = truth[1][0] = -0.24;
    truth[0][8] = truth[1][8] = -0.08;
    truth[0][9] = truth[1][9] = 0.05;
    const auto error = sceneError(estimate, truth);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->bins, 3) << "sides of one plane count once";
    EXPECT_EQ(knownHeights(truth), 3);
    EXPECT_NEAR(error->median, 0.03, 1e-12);
    EXPECT_NEAR(error->mean, 0.14 / 3.0, 1e-12);
    EXPECT_NEAR(error->largest, 0.1, 1e-12);
}

TEST(SceneError, joinsSidesThatDiffer)
{
    const TwoTrackEstimate estimate = leftStepEstimate();
    std::array<OptionalHeights, 2> truth{};
    truth[0][8] = -0.05;
    truth[1][8] = -0.05;  // the right side is at −0.25 m
    const auto error = sceneError(estimate, truth);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->bins, 2);
    EXPECT_NEAR(error->median, 0.1, 1e-12) << "the mean of the middle two";
    EXPECT_NEAR(error->largest, 0.2, 1e-12);
}

}  // namespace
}  // namespace terratact
