#include "core/eval/baselines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "core/learn/model/surface_rows.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

Proprioception senses(const Eigen::VectorXd& x)
{
    FeatureValues values;
    for (std::size_t k = 0; k < kFeatures; ++k) values[k] = x[static_cast<Eigen::Index>(k)];
    return proprioception(values);
}

/// Rows whose heights are linear in the features, each with noise of 1 cm.
struct World {
    ModelData model;
    Eigen::MatrixXd weights;

    explicit World(Eigen::Index rows, double noise = 0.01)
    {
        std::mt19937_64 rng(4);
        std::normal_distribution<double> normal;
        const auto random = [&](double) { return normal(rng); };
        model.features = Eigen::MatrixXd::Zero(rows, kFeatures).unaryExpr(random) * 0.2;
        weights = Eigen::MatrixXd::Zero(kFeatures, kBins).unaryExpr(random) * 0.3;
        model.heights =
            model.features * weights + noise * Eigen::MatrixXd::Zero(rows, kBins).unaryExpr(random);
        model.heights.array() -= 0.2;
    }
    double truth(const Eigen::VectorXd& x, Eigen::Index bin) const
    {
        return x.dot(weights.col(bin)) - 0.2;
    }
};

void oneByOne(int count, const std::function<void(int)>& work)
{
    for (int k = 0; k < count; ++k) work(k);
}

const Baseline& named(const std::vector<std::unique_ptr<Baseline>>& all, std::string_view name)
{
    for (const auto& baseline : all)
        if (baseline->name() == name) return *baseline;
    throw std::invalid_argument("no such baseline");
}

TEST(Baselines, learnFromCompleteRowsOnly)
{
    const World world(60);
    ModelData holed = world.model;
    holed.unknownBins.assign(60, 0U);
    for (std::size_t u = 1; u < 60; u += 3) {
        holed.unknownBins[u] = 1U << 4U;
        holed.heights(static_cast<Eigen::Index>(u), 4) = 0.0;
    }
    ModelData rest;
    const std::vector<int> rows = completeRows(holed);
    rest.heights = holed.heights(rows, Eigen::all);
    rest.features = holed.features(rows, Eigen::all);
    const auto some = fitBaselines(absolem(), holed, oneByOne);
    const auto same = fitBaselines(absolem(), rest, oneByOne);
    const Proprioception s = senses(world.model.features.row(1).transpose());
    for (std::size_t k = 0; k < same.size(); ++k) {
        EXPECT_EQ(some[k]->forecast(s).height, same[k]->forecast(s).height) << same[k]->name();
        EXPECT_EQ(some[k]->forecast(s).sd, same[k]->forecast(s).sd) << same[k]->name();
    }
    holed.unknownBins.assign(60, 1U);
    EXPECT_THROW((void)fitBaselines(absolem(), holed, oneByOne), std::invalid_argument);
}

TEST(Baselines, areFourInAFixedOrderAndNeedRows)
{
    const auto all = fitBaselines(absolem(), World(40).model, oneByOne);
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[0]->name(), "flat");
    EXPECT_EQ(all[1]->name(), "linear");
    EXPECT_EQ(all[2]->name(), "nearest");
    EXPECT_EQ(all[3]->name(), "gp-s");
    EXPECT_THROW(fitBaselines(absolem(), World(20).model, oneByOne), std::invalid_argument);
}

TEST(Baselines, findALinearLawAndItsNoise)
{
    const World world(300);
    const auto all = fitBaselines(absolem(), world.model, oneByOne);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(kFeatures, -0.2, 0.2);
    const BandForecast linear = named(all, "linear").forecast(senses(x));
    const BandForecast gp = named(all, "gp-s").forecast(senses(x));
    for (std::size_t i = 0; i < kBins; ++i) {
        const double truth = world.truth(x, static_cast<Eigen::Index>(i));
        EXPECT_NEAR(linear.height[i], truth, 0.005) << i;
        EXPECT_NEAR(linear.sd[i], 0.01, 0.002) << i;
        EXPECT_NEAR(gp.height[i], truth, 0.01) << i;
        EXPECT_NEAR(gp.sd[i], 0.0105, 0.004) << i;
    }
}

TEST(Linear, ignoresAFeatureThatNeverVaries)
{
    World world(60, 0.0);
    world.model.features.col(7).setConstant(3.0);
    world.model.heights = world.model.features.leftCols(7) * world.weights.topRows(7);
    const auto all = fitBaselines(absolem(), world.model, oneByOne);
    Eigen::VectorXd x = world.model.features.row(5).transpose();
    for (const std::string_view name : {"linear", "nearest", "gp-s"}) {
        const BandForecast found = named(all, name).forecast(senses(x));
        for (std::size_t i = 0; i < kBins; ++i)
            EXPECT_NEAR(found.height[i], world.model.heights(5, static_cast<Eigen::Index>(i)), 0.01)
                << name << i;
    }
    EXPECT_DOUBLE_EQ(named(all, "linear").forecast(senses(x)).sd[3], 0.001);  // never less
}

TEST(Flat, isTheTracksLowerEdgeAtTheMeasuredPitch)
{
    const RobotModel robot = absolem();
    World world(30);
    world.model.features.col(0).setZero();
    const double floor = robot.trackZ - robot.trackRadius - robot.imu.z;
    world.model.heights.setConstant(floor);
    world.model.heights.col(4).array() += 0.05;
    const auto all = fitBaselines(robot, world.model, oneByOne);
    Proprioception s;
    const BandForecast level = named(all, "flat").forecast(s);
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_NEAR(level.height[i], floor, 1e-12);
        EXPECT_NEAR(level.sd[i], i == 4 ? 0.05 : 0.001, 1e-9);
    }
    s.pitch = 0.3;
    const BandForecast uphill = named(all, "flat").forecast(s);
    EXPECT_NEAR(uphill.height[10] - uphill.height[0], std::tan(0.3), 1e-9);  // 1 m apart
    EXPECT_NEAR(uphill.height[3] - uphill.height[2], 0.1 * std::tan(0.3), 1e-9);
}

TEST(Nearest, isTheRowWithTheLeastStandardisedDistance)
{
    World world(60);
    world.model.features.col(1) *= 1000.0;  // whatever the unit
    const auto all = fitBaselines(absolem(), world.model, oneByOne);
    Eigen::VectorXd x = world.model.features.row(17).transpose();
    x[1] += 1.0;
    const BandForecast found = named(all, "nearest").forecast(senses(x));
    double least = 1.0;
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_EQ(found.height[i], world.model.heights(17, static_cast<Eigen::Index>(i)));
        least = std::min(least, found.sd[i]);
    }
    EXPECT_GT(least, 0.02);  // the others differ by more than the noise
}

TEST(BaselineEstimate, isAGaussianBandWithItsDraws)
{
    const World world(60);
    const auto all = fitBaselines(absolem(), world.model, oneByOne);
    const Proprioception s = senses(Eigen::VectorXd::Constant(kFeatures, 0.1));
    const BandForecast band = named(all, "linear").forecast(s);
    const TerrainEstimate e = baselineEstimate(named(all, "linear"), absolem(), s, 1, 4000);
    ASSERT_EQ(e.draws.size(), 4000U);
    double mean = 0.0;
    double square = 0.0;
    double product = 0.0;
    for (const Heights& h : e.draws) {
        const double a = (h[2] - band.height[2]) / band.sd[2];
        mean += a / 4000.0;
        square += a * a / 4000.0;
        product += a * (h[3] - band.height[3]) / band.sd[3] / 4000.0;
    }
    EXPECT_NEAR(mean, 0.0, 0.065);
    EXPECT_NEAR(square, 1.0, 0.09);
    EXPECT_NEAR(product, 0.0, 0.065);
    EXPECT_EQ(e.height, band.height);
    EXPECT_EQ(e.mean, band.height);
    EXPECT_EQ(e.sd, band.sd);
    EXPECT_NEAR(e.q90[2] - e.q10[2], 2.563 * band.sd[2], 0.001 * band.sd[2]);
    EXPECT_EQ(e.draws, baselineEstimate(named(all, "linear"), absolem(), s, 1, 4000).draws);
    Proprioception blind;
    EXPECT_THROW((void)baselineEstimate(named(all, "linear"), absolem(), blind, 1),
                 std::invalid_argument);
    EXPECT_EQ(baselineEstimate(named(all, "flat"), absolem(), blind, 1).draws.size(), 200U);
}

}  // namespace
}  // namespace terratact
