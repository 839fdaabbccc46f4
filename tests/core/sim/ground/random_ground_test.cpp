#include "core/sim/ground/random_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/infer/estimate/hazards.h"
#include "core/sim/ground/hazard_terrain.h"
#include "core/sim/ground/random_terrain.h"
#include "tests/support/absolem.h"
#include "tests/support/faces.h"

namespace terratact {
namespace {

const std::vector<double> kYs = groundYs(absolem());

double crossSlope(const GroundLines& ground, double x)
{
    const double left = ground.lines().front().profile.heightAt(x);
    const double right = ground.lines().back().profile.heightAt(x);
    return std::atan((left - right) / (kYs.front() - kYs.back()));
}

TEST(RandomGround, hasALineUnderEachTrackAndFlipper)
{
    EXPECT_EQ(kYs, (std::vector<double>{0.272, 0.1985, -0.1985, -0.272}));
    std::mt19937_64 rng(1);
    for (int k = 0; k < 40; ++k) {
        const GroundLines ground = randomGround(randomGroundKind(rng), kYs, rng);
        ASSERT_EQ(ground.lines().size(), kYs.size());
        EXPECT_GT(ground.end() - ground.begin(), 5.0);
    }
}

TEST(RandomGround, hasItsKindsInTheirShares)
{
    std::mt19937_64 rng(2);
    std::array<int, 4> count{};
    for (int k = 0; k < 4000; ++k) ++count[static_cast<std::size_t>(randomGroundKind(rng))];
    EXPECT_NEAR(count[0], 600, 100);
    EXPECT_NEAR(count[1], 1400, 120);
    EXPECT_NEAR(count[2], 800, 100);
    EXPECT_NEAR(count[3], 1200, 120);
}

TEST(RandomGround, isASixthSlopedByMoreThanSevenDegrees)
{
    // A third has a cross slope, uniform up to ±15°: half of those are beyond 7.5°.
    std::mt19937_64 rng(3);
    int steep = 0, equal = 0;
    for (int k = 0; k < 1200; ++k) {
        const GroundLines ground = randomGround(GroundKind::Symmetric, kYs, rng);
        equal += ground.isOnePlane();
        steep += std::abs(crossSlope(ground, 3.0)) > 0.1309;
        EXPECT_LT(std::abs(crossSlope(ground, 3.0)), 0.262);
    }
    EXPECT_NEAR(equal, 800, 70);
    EXPECT_NEAR(steep, 200, 50);
}

TEST(RandomGround, obliqueLinesAreShiftedByTheirY)
{
    std::mt19937_64 rng(4);
    int tested = 0;
    for (int k = 0; k < 60; ++k) {
        const GroundLines ground = randomGround(GroundKind::Oblique, kYs, rng);
        const auto& lines = ground.lines();
        const double way = lines[0].profile.begin() - lines[3].profile.begin();
        const double slope = lines[0].profile.points()[0].z - lines[3].profile.points()[0].z;
        EXPECT_LT(std::abs(way), (kYs[0] - kYs[3]) * 1.0001);  // tan 45°
        for (const double x : {2.0, 3.0, 4.0})
            EXPECT_NEAR(lines[0].profile.meanOver(x + way, x + way + 0.1),
                        lines[3].profile.meanOver(x, x + 0.1) + slope, 1e-6);
        tested += std::abs(way) > 0.1;
    }
    EXPECT_GT(tested, 20);
}

TEST(RandomGround, oneSidedFeaturesAreOnOneSide)
{
    std::mt19937_64 rng(5);
    int flipperAlone = 0, track = 0;
    for (int k = 0; k < 100; ++k) {
        const GroundLines ground = randomGround(GroundKind::OneSided, kYs, rng);
        for (const GroundLine& line : ground.lines()) {
            const bool feature = tallestFace(line.profile) > 0.02;
            (std::abs(line.y) > 0.25 ? flipperAlone : track) += feature;
        }
    }
    EXPECT_GT(track, 30);
    EXPECT_GT(flipperAlone, track);
}

TEST(RandomGround, roughnessCorrelatesByDistance)
{
    std::mt19937_64 rng(6);
    double product = 0.0, left = 0.0, right = 0.0;
    const TerrainProfile level({{0.0, 0.0}});
    for (int k = 0; k < 400; ++k) {
        std::vector<GroundLine> lines{{0.2, level}, {0.1, level}, {-0.1, level}};
        addRoughness(lines, 256e-6, 0.3, rng);
        for (const double x : {1.0, 3.0, 5.0}) {
            const double a = lines[0].profile.heightAt(x), b = lines[2].profile.heightAt(x);
            product += a * b;
            left += a * a;
            right += b * b;
        }
    }
    EXPECT_NEAR(product / std::sqrt(left * right), std::exp(-0.3 / 0.3), 0.1);
    EXPECT_NEAR(left / right, 1.0, 0.25);
}

TEST(RandomGround, isTheSameForTheSameSeed)
{
    std::mt19937_64 a(7), b(7);
    for (int k = 0; k < 20; ++k) {
        const GroundLines first = randomGround(randomGroundKind(a), kYs, a);
        const GroundLines second = randomGround(randomGroundKind(b), kYs, b);
        for (std::size_t i = 0; i < kYs.size(); ++i)
            EXPECT_EQ(first.lines()[i].profile.points(), second.lines()[i].profile.points());
    }
}

TEST(HazardGround, isOnTheSidesThatAreAskedFor)
{
    std::mt19937_64 rng(8);
    for (const Hazard hazard : kHazards)
        for (const HazardSide side : {HazardSide::Left, HazardSide::Right, HazardSide::Both}) {
            const GroundLines ground = randomHazardGround(hazard, side, 0.0, kYs, rng);
            EXPECT_EQ(ground.isOnePlane(), side == HazardSide::Both);
            const auto height = [&](double y) {
                const auto& points = ground.under(y).points();
                const auto [low, high] = std::ranges::minmax(points, {}, &Vec2::z);
                return high.z - low.z;
            };
            for (const double y : kYs) {
                const bool has = side == HazardSide::Both || (side == HazardSide::Left) == (y > 0);
                EXPECT_EQ(height(y) >= kSmallestHazard - 1e-9, has) << name(hazard) << y;
                EXPECT_EQ(height(y) > 0.0, has);
            }
        }
    const GroundLines rough = randomHazardGround(Hazard::Drop, HazardSide::Left, 64e-6, kYs, rng);
    EXPECT_FALSE(rough.under(-0.2).heightAt(1.0) == rough.under(-0.3).heightAt(1.0));
    EXPECT_THROW((void)randomHazardGround(Hazard::Drop, HazardSide::Left, -1.0, kYs, rng),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
