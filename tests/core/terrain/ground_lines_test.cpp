#include "core/terrain/ground_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

TerrainProfile level(double height, double begin = 0.0, double end = 6.0)
{
    return TerrainProfile({{begin, height}, {end, height}});
}

double heightAt(const GroundLines& ground, double y)
{
    return ground.under(y).heightAt(1.0);
}

TEST(GroundLines, ofOneProfileAreEqualEverywhere)
{
    const GroundLines ground(level(0.3));
    EXPECT_TRUE(ground.isOnePlane());
    for (const double y : {-0.272, -0.1985, 0.1985, 0.272}) EXPECT_EQ(heightAt(ground, y), 0.3);
}

TEST(GroundLines, giveEveryPartItsNearestLine)
{
    const GroundLines ground({{-0.2, level(-0.1)}, {0.272, level(0.2)}, {0.1985, level(0.1)}});
    EXPECT_EQ(ground.lines().front().y, 0.272);
    EXPECT_EQ(heightAt(ground, 0.27), 0.2);
    EXPECT_EQ(heightAt(ground, 0.21), 0.1);
    EXPECT_EQ(heightAt(ground, 1.0), 0.2);
    EXPECT_EQ(heightAt(ground, -0.272), -0.1);  // a file of two lines serves tracks and flippers
    EXPECT_FALSE(ground.isOnePlane());
    // Of two lines that are equally near, both sides take the inner one.
    const GroundLines even(
        {{0.25, level(1.0)}, {0.125, level(2.0)}, {-0.125, level(3.0)}, {-0.25, level(4.0)}});
    EXPECT_EQ(heightAt(even, 0.1875), 2.0);
    EXPECT_EQ(heightAt(even, -0.1875), 3.0);
}

TEST(GroundLines, coverWhatAllLinesCover)
{
    const GroundLines ground({{0.2, level(0.0, 0.5, 6.0)}, {-0.2, level(0.0, 0.0, 5.0)}});
    EXPECT_EQ(ground.begin(), 0.5);
    EXPECT_EQ(ground.end(), 5.0);
}

TEST(GroundLines, mirroredExchangeTheSides)
{
    const GroundLines ground({{0.2, level(1.0)}, {-0.3, level(2.0)}});
    const GroundLines mirror = ground.mirrored();
    EXPECT_EQ(heightAt(mirror, -0.2), 1.0);
    EXPECT_EQ(heightAt(mirror, 0.3), 2.0);
    EXPECT_EQ(heightAt(mirror.mirrored(), 0.2), 1.0);
}

TEST(SideHeights, areOfTheTrackAndAheadOfTheFlipper)
{
    RobotModel robot;  // Absolem's y
    const GroundLines ground(
        {{0.272, level(0.2)}, {0.1985, level(0.1)}, {-0.1985, level(-0.1)}, {-0.272, level(-0.2)}});
    const Heights left = sideHeights(ground, robot, Side::Left, {3.0, 0.5});
    const Heights right = sideHeights(ground, robot, Side::Right, {3.0, 0.5});
    for (int bin = 0; bin < kBins; ++bin) {
        const double height = binCentre(bin) < 0.25 ? 0.1 : 0.2;
        EXPECT_NEAR(left[static_cast<std::size_t>(bin)], height - 0.5, 1e-12) << bin;
        EXPECT_NEAR(right[static_cast<std::size_t>(bin)], -height - 0.5, 1e-12) << bin;
    }
}

TEST(GroundLines, thatCannotBeAreRefused)
{
    using Lines = std::vector<GroundLine>;
    EXPECT_THROW(GroundLines(Lines{}), std::invalid_argument);
    EXPECT_THROW(GroundLines(Lines{{std::nan(""), level(0.0)}}), std::invalid_argument);
    EXPECT_THROW(GroundLines(Lines{{0.2, level(0.0)}, {0.2, level(1.0)}}), std::invalid_argument);
    EXPECT_THROW(GroundLines(Lines{{0.2, level(0.0, 0.0, 1.0)}, {-0.2, level(0.0, 2.0, 3.0)}}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
