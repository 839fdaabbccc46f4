#include "core/sim/rest/skin_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/skin_hits.h"

namespace terratact {
namespace {

TEST(SkinHull, isEnteredByTheDepthBelowItsSurface)
{
    const SkinHull disc({{0.0, 1.0}, {1.0, 1.0}, 0.1, 0.1}, 0.001);
    const auto hit = hitOf(disc, {0.4, 0.95});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->depth, 0.051, 1e-12);
    EXPECT_NEAR(hit->normal.z, -1.0, 1e-12);
    EXPECT_FALSE(hitOf(disc, {0.4, 0.8989}));
}

TEST(SkinHull, isLeftThroughItsNoseByAPointOnAFace)
{
    const SkinHull hull({{0.0, 0.0}, {0.3, 0.0}, 0.09, 0.03}, 0.0);
    const auto hit = hitOf(hull, {0.325, 0.0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->depth, 0.005, 1e-12);
    EXPECT_NEAR(hit->normal.x, 1.0, 1e-12);
}

TEST(SkinHull, depthIsTheDistanceToTheNearestPointOutside)
{
    // Moving the hull by depth along −normal must just free the point; a slightly smaller move must
    // not.
    const TaperedHull shape{{0.0, 0.0}, {0.25, 0.1}, 0.09, 0.03};
    std::mt19937_64 rng(3);
    std::uniform_real_distribution<double> u(-0.2, 0.4);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 p{u(rng), u(rng)};
        const auto hit = hitOf(SkinHull(shape, 0.0), p);
        if (!hit || hit->depth > 0.025) continue;
        ++inside;
        EXPECT_NEAR(std::hypot(hit->normal.x, hit->normal.z), 1.0, 1e-12);
        const auto depthAfter = [&](double way) {
            const Vec2 d{-hit->normal.x * way, -hit->normal.z * way};
            const TaperedHull moved{{shape.a.x + d.x, shape.a.z + d.z},
                                    {shape.b.x + d.x, shape.b.z + d.z},
                                    shape.ra,
                                    shape.rb};
            const auto again = hitOf(SkinHull(moved, 0.0), p);
            return again ? again->depth : 0.0;
        };
        EXPECT_NEAR(depthAfter(hit->depth + 1e-9), 0.0, 1e-9);
        EXPECT_NEAR(depthAfter(0.5 * hit->depth), 0.5 * hit->depth, 1e-9);
    }
    EXPECT_GT(inside, 100);
}

TEST(SkinPolygon, isEnteredAtItsNearestEdgeInEitherDirection)
{
    for (const bool reversed : {false, true}) {
        std::vector<Vec2> box{{-0.3, 0.1}, {0.1, 0.1}, {0.1, 0.2}, {-0.3, 0.2}};
        if (reversed) std::reverse(box.begin(), box.end());
        const SkinPolygon polygon(box, 0.001);
        const auto hit = hitOf(polygon, {-0.2, 0.11});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->depth, 0.011, 1e-12);
        EXPECT_NEAR(hit->normal.z, -1.0, 1e-12);
        EXPECT_FALSE(hitOf(polygon, {-0.2, 0.098}));
    }
}

}  // namespace
}  // namespace terratact
