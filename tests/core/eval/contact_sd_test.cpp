#include "core/eval/contact_sd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "core/sim/drive.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/terrain/kinematic_reconstruction.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// A scene whose fourth and sixth elements feel these forces; every height is `truth`.
Scene feeling(double fourth, double sixth, double truth)
{
    Scene scene;
    scene.s.front = 0.3;
    scene.s.force = {0.0, 0.0, 0.0, fourth, 0.0, sixth};
    scene.truth.fill(truth);
    return scene;
}

TEST(ContactResiduals, areTruthMinusContactWhereBothAreKnown)
{
    const RobotModel robot = absolem();
    const std::vector<Scene> scenes{feeling(8.0, 0.0, -0.2), feeling(0.0, 0.0, -0.2),
                                    feeling(0.0, 9.0, -0.1)};
    const auto residuals = contactResiduals(robot, scenes, 2.0, ContactRule::Isolated);
    ASSERT_EQ(residuals.size(), 2U);
    const Contact fourth = reconstructContacts(robot, scenes[0].s, 2.0, true).contacts.at(0);
    EXPECT_EQ(residuals[0].bin, fourth.bin);
    EXPECT_DOUBLE_EQ(residuals[0].residual, -0.2 - fourth.height);
    EXPECT_GT(residuals[1].bin, residuals[0].bin);

    Scene unknown = scenes[0];
    unknown.truth = {};
    EXPECT_TRUE(contactResiduals(robot, std::vector{unknown}, 2.0, ContactRule::Isolated).empty());
    EXPECT_TRUE(contactResiduals(robot, {}, 2.0, ContactRule::Any).empty());
    EXPECT_THROW(contactResiduals(robot, scenes, -1.0, ContactRule::Any), std::invalid_argument);
}

TEST(ContactResiduals, followTheRule)
{
    const RobotModel robot = absolem();
    const std::vector<Scene> scenes{feeling(8.0, 8.0, -0.2)};
    EXPECT_TRUE(contactResiduals(robot, scenes, 2.0, ContactRule::Isolated).empty());
    EXPECT_EQ(contactResiduals(robot, scenes, 2.0, ContactRule::Any).size(), 2U);
    EXPECT_TRUE(contactResiduals(robot, scenes, 8.0, ContactRule::Any).empty());
}

TEST(ContactResiduals, areSmallOnFlatGround)
{
    const TerrainProfile flat = flatTerrain(4.0);
    std::mt19937_64 rng(1);
    int skipped = 0;
    const auto scenes = driveOver(absolem(), flat, stopsOver(flat, 0.2), "1", {},
                                  {.noise = SensorNoise::none()}, rng, skipped);
    const auto residuals = contactResiduals(absolem(), scenes, 2.0, ContactRule::Any);
    ASSERT_FALSE(residuals.empty());
    for (const ContactResidual& r : residuals) EXPECT_NEAR(r.residual, 0.0, 0.005);
}

TEST(ResidualStatistics, matchAHandCalculation)
{
    const ResidualStatistics s = residualStatistics({1.0, 2.0, 3.0, 4.0, 100.0});
    EXPECT_EQ(s.n, 5U);
    EXPECT_DOUBLE_EQ(s.mean, 22.0);
    EXPECT_DOUBLE_EQ(s.sd, std::sqrt((441.0 + 400.0 + 361.0 + 324.0 + 6084.0) / 4.0));
    EXPECT_DOUBLE_EQ(s.robustSd, 1.4826);  // deviations from 3: 2, 1, 0, 1, 97
    EXPECT_EQ(residualStatistics({}), ResidualStatistics{});
    EXPECT_EQ(residualStatistics({0.5}), (ResidualStatistics{1, 0.5, 0.0, 0.0}));
}

TEST(ResidualStatistics, bothFindTheSdOfANormal)
{
    std::mt19937_64 rng(2);
    std::normal_distribution<double> normal(0.01, 0.02);
    std::vector<double> x(20000);
    for (double& value : x) value = normal(rng);
    const ResidualStatistics s = residualStatistics(x);
    EXPECT_NEAR(s.mean, 0.01, 4.0 * 0.02 / std::sqrt(20000.0));
    EXPECT_NEAR(s.sd, 0.02, 0.0005);
    EXPECT_NEAR(s.robustSd, 0.02, 0.0008);
}

TEST(ContactSummary, separatesBins)
{
    const std::vector<ContactResidual> residuals{{7, 0.01}, {7, 0.03}, {8, -0.04}};
    const ContactSummary summary = summariseContacts(residuals);
    EXPECT_EQ(summary.bin[7].n, 2U);
    EXPECT_DOUBLE_EQ(summary.bin[7].mean, 0.02);
    EXPECT_EQ(summary.bin[8].n, 1U);
    EXPECT_EQ(summary.bin[6], ResidualStatistics{});
    EXPECT_EQ(summary.all.n, 3U);
    EXPECT_NEAR(summary.all.mean, 0.0, 1e-15);
    EXPECT_EQ(summariseContacts({}).all, ResidualStatistics{});
}

}  // namespace
}  // namespace terratact
