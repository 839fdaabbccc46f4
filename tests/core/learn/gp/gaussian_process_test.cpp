#include "core/learn/gp/gaussian_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/learn/gp/scene_conditional.h"
#include "tests/support/process_data.h"

namespace terratact {
namespace {

/// Returns the textbook prediction by a dense solve.
Normal reference(const ProcessData& data, const Eigen::VectorXd& x)
{
    const Eigen::LLT<Eigen::MatrixXd> K(covariance(data));
    Eigen::VectorXd k(data.X.rows());
    for (Eigen::Index u = 0; u < k.size(); ++u) k[u] = kernel(data.X.row(u), x, data.hyper);
    const double prior = std::pow(data.hyper.signalSd, 2) + std::pow(data.hyper.noiseSd, 2);
    return {k.dot(K.solve(data.y)), prior - k.dot(K.solve(k))};
}

TEST(GaussianProcess, predictsAsTheTextbookFormula)
{
    for (const int U : {1, 2, 7, 8, 9, 65, 130}) {
        const ProcessData data = someData(U, 3);
        const GaussianProcess gp(data.X, data.y, data.hyper, 0.25);
        for (const double at : {-1.0, 0.0, 0.4, 9.0}) {
            const Eigen::Vector3d x(at, 0.3, -at);
            const Normal expected = reference(data, x);
            const Normal got = gp.predict(x);
            EXPECT_NEAR(got.mean, 0.25 + expected.mean, 1e-12) << U << " rows";
            EXPECT_NEAR(got.variance, expected.variance, 1e-12) << U << " rows";
        }
    }
}

TEST(GaussianProcess, farFromAllDataReturnsThePrior)
{
    const ProcessData data = someData(20, 2);
    const Normal far =
        GaussianProcess(data.X, data.y, data.hyper, -0.3).predict(Eigen::Vector2d(1e6, -1e6));
    EXPECT_DOUBLE_EQ(far.mean, -0.3);
    EXPECT_DOUBLE_EQ(far.variance, 0.9 * 0.9 + 0.15 * 0.15);
}

TEST(GaussianProcess, varianceNeverFallsBelowTheNoise)
{
    ProcessData data = someData(60, 2);
    data.hyper.lengthScale.setConstant(0.2);
    data.hyper.noiseSd = 0.0;
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.0);
    for (Eigen::Index u = 0; u < 60; ++u) {
        const double variance = gp.predict(data.X.row(u).transpose()).variance;
        EXPECT_GE(variance, 0.0);
        EXPECT_LT(variance, 1e-12);
    }
}

TEST(SceneConditional, predictsLikeTheWholeInput)
{
    const ProcessData data = someData(77, 6);
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.1);
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(6);
    for (double& v : x) v = normal(rng);
    SceneConditional conditional(gp, x, {4, 1}, Precision::Double);
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
    for (const int n : {1, 3, 8, 17, 2}) {
        Eigen::MatrixXd moving(2, n);
        for (double& v : moving.reshaped()) v = normal(rng);
        conditional.predict(moving, mean, variance);
        ASSERT_EQ(mean.size(), n);
        for (int c = 0; c < n; ++c) {
            Eigen::VectorXd whole = x;
            whole[4] = moving(0, c);
            whole[1] = moving(1, c);
            const Normal expected = gp.predict(whole);
            EXPECT_NEAR(mean[c], expected.mean, 1e-13);
            EXPECT_NEAR(variance[c], expected.variance, 1e-13);
        }
    }
}

TEST(PredictTogether, givesEverySceneWhatItGetsAlone)
{
    const ProcessData large = someData(120, 6);
    ProcessData small = someData(50, 6, 2);  // uses the buffers that the large one has filled
    ProcessData smooth = someData(200, 6, 3);
    small.hyper.lengthScale /= 4.0;
    smooth.hyper.lengthScale *= 8.0;
    const GaussianProcess a(large.X, large.y, large.hyper, 0.1);
    const GaussianProcess b(small.X, small.y, small.hyper, 0.2);
    const GaussianProcess c(smooth.X, smooth.y, smooth.hyper, 0.3);
    ASSERT_EQ(b.varianceRows(), b.rows());
    ASSERT_LT(c.varianceRows(), 0.9 * static_cast<double>(c.rows()));
    const std::array<const GaussianProcess*, 3> processes{&a, &c, &b};
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(6);
    for (double& v : x) v = normal(rng);
    const std::vector<std::vector<int>> moving{{4, 1}, {0, 2, 3}, {}, {5}};
    std::vector<SceneConditional> scenes;
    std::vector<Eigen::MatrixXd> inputs;
    for (const int columns : {3, 8, 1, 4, 12, 16, 5, 70})  // groups of eight begin anywhere
        for (const Precision precision : {Precision::Single, Precision::Double}) {
            const auto& m = moving[scenes.size() % moving.size()];
            scenes.emplace_back(*processes[scenes.size() % 3], x, m, precision);
            inputs.emplace_back(static_cast<Eigen::Index>(m.size()), columns);
            for (double& v : inputs.back().reshaped()) v = normal(rng);
        }
    std::vector<Eigen::VectorXd> mean(scenes.size()), variance(scenes.size());
    std::vector<ScenePrediction> asked;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        asked.push_back({&scenes[k], &inputs[k], &mean[k], &variance[k]});
    PredictionRoom room;
    for (int again = 0; again < 2; ++again) {
        predictTogether(asked, room);
        for (std::size_t k = 0; k < scenes.size(); ++k) {
            Eigen::VectorXd aloneMean, aloneVariance;
            scenes[k].predict(inputs[k], aloneMean, aloneVariance);
            EXPECT_EQ(mean[k], aloneMean) << k;
            EXPECT_EQ(variance[k], aloneVariance) << k;
        }
    }
    inputs[1](0, 0) = std::nan("");
    EXPECT_THROW(predictTogether(asked, room), std::invalid_argument);
    predictTogether({}, room);
}

/// Predictions at random inputs in both precisions, 40 columns, all inputs moving.
struct BothPrecisions {
    explicit BothPrecisions(const GaussianProcess& gp)
    {
        std::mt19937_64 rng(9);
        std::normal_distribution<double> normal;
        std::vector<int> all(static_cast<std::size_t>(gp.inputs()));
        for (std::size_t d = 0; d < all.size(); ++d) all[d] = static_cast<int>(d);
        const Eigen::VectorXd x = Eigen::VectorXd::Zero(gp.inputs());
        Eigen::MatrixXd inputs(gp.inputs(), 40);
        for (double& v : inputs.reshaped()) v = normal(rng);
        SceneConditional(gp, x, all, Precision::Single).predict(inputs, meanSingle, single);
        SceneConditional(gp, x, all, Precision::Double).predict(inputs, mean, variance);
    }
    Eigen::VectorXd mean, variance, meanSingle, single;
};

TEST(SceneConditional, singlePrecisionKeepsMeanAndNearlyTheVariance)
{
    const ProcessData data = someData(300, 4);
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.1);
    ASSERT_EQ(gp.usable(Precision::Single), Precision::Single);
    EXPECT_EQ(gp.usable(Precision::Double), Precision::Double);
    const BothPrecisions both(gp);
    EXPECT_EQ(both.mean, both.meanSingle);
    EXPECT_NE(both.variance, both.single);
    EXPECT_LT((both.single - both.variance).cwiseAbs().maxCoeff(),
              kSingleErrorElsewhere * gp.singleError());
    EXPECT_LT((both.single.cwiseSqrt() - both.variance.cwiseSqrt()).cwiseAbs().maxCoeff(),
              5e-3 * data.hyper.noiseSd);
}

TEST(SceneConditional, fewerRowsKeepMeanAndNearlyTheVariance)
{
    ProcessData data = someData(400, 4);
    data.hyper.lengthScale *= 2.0;
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.1);
    ASSERT_EQ(gp.usable(Precision::Single), Precision::Single);
    ASSERT_LT(gp.varianceRows(), 0.9 * static_cast<double>(gp.rows()));
    const BothPrecisions both(gp);
    EXPECT_LT((both.mean - both.meanSingle).cwiseAbs().maxCoeff(), 1e-9);
    const Eigen::ArrayXd share = (both.single - both.variance).array() / both.variance.array();
    EXPECT_LT(share.abs().maxCoeff(), 3e-3);
    EXPECT_GT(share.abs().maxCoeff(), 1e-7);
}

TEST(SceneConditional, usesAllRowsIfAReductionIsInaccurate)
{
    // Two neighbouring places explain each other, but only hundreds of rows determine the function
    // beyond them.
    Eigen::MatrixXd X(1000, 1);
    const double noise = 0.1;
    for (Eigen::Index u = 0; u < X.rows(); ++u) X(u, 0) = u % 2 == 0 ? 0.0 : 0.0099 * noise;
    const GaussianProcess gp(X, X.col(0).array().sin().matrix(),
                             {Eigen::VectorXd::Ones(1), 1.0, noise}, 0.0);
    EXPECT_EQ(gp.varianceRows(), gp.rows());
}

TEST(SceneConditional, usesDoubleIfSinglePrecisionIsInaccurate)
{
    ProcessData data =
        someData(300, 2);  // dense in two dimensions: |L⁻¹k|² is σ_f² but for a millionth
    data.hyper.noiseSd = 1e-4;
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.1);
    EXPECT_EQ(gp.usable(Precision::Single), Precision::Double);
    const BothPrecisions both(gp);
    EXPECT_EQ(both.variance, both.single);
    EXPECT_GE(both.single.minCoeff(), 1e-8);
    data.hyper.noiseSd = 0.0;
    // well-conditioned, but without noise to compare with
    data.hyper.lengthScale.setConstant(1e-3);
    EXPECT_EQ(GaussianProcess(data.X, data.y, data.hyper, 0.0).usable(Precision::Single),
              Precision::Double);
}

TEST(GaussianProcess, refusesWhatItCannotAnswer)
{
    const ProcessData good = someData(10, 2);
    const auto build = [](const ProcessData& d) { return GaussianProcess(d.X, d.y, d.hyper, 0.0); };
    EXPECT_NO_THROW(build(good));
    ProcessData bad = good;
    bad.X(3, 1) = std::nan("");
    EXPECT_THROW(build(bad), std::invalid_argument);
    bad = good;
    bad.y[0] = INFINITY;
    EXPECT_THROW(build(bad), std::invalid_argument);
    bad = good;
    bad.hyper.lengthScale[0] = 0.0;
    EXPECT_THROW(build(bad), std::invalid_argument);
    const GaussianProcess gp = build(good);
    EXPECT_THROW((void)gp.predict(Eigen::Vector2d(0.0, std::nan(""))), std::invalid_argument);
    EXPECT_THROW((void)gp.predict(Eigen::Vector3d(0.0, 0.0, 0.0)), std::invalid_argument);
}

TEST(GaussianProcess, tinyLengthScalesReturnTheNoisyData)
{
    ProcessData data = someData(30, 2);
    data.hyper.lengthScale.setConstant(1e-8);
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.0);
    const Normal at = gp.predict(data.X.row(5).transpose());
    const double signal2 = 0.81;
    const double noise2 = 0.0225;
    EXPECT_NEAR(at.mean, data.y[5] * signal2 / (signal2 + noise2), 1e-12);
}

TEST(GaussianProcess, aNoisyRowFollowsTheOthers)
{
    ProcessData data = someData(40, 2);
    const Eigen::VectorXd x = data.X.row(7).transpose();
    const GaussianProcess clean(data.X, data.y, data.hyper, 0.0);
    data.y[7] += 3.0;
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(40);
    variance[7] = 9.0;
    const GaussianProcess misled(data.X, data.y, data.hyper, 0.0);
    EXPECT_GT(std::abs(misled.predict(x).mean - clean.predict(x).mean), 0.5);
    const GaussianProcess told(data.X, data.y, data.hyper, 0.0, {}, variance);
    // As without the row, but for its small weight.
    std::vector<int> others;
    for (int u = 0; u < 40; ++u)
        if (u != 7) others.push_back(u);
    const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0);
    EXPECT_NEAR(told.predict(x).mean, without.predict(x).mean, 0.12);
    EXPECT_NEAR(told.predict(x).variance, without.predict(x).variance, 0.01);
}

TEST(GaussianProcess, addsRowVarianceToTheDiagonal)
{
    const ProcessData data = someData(30, 2);
    const Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(30, 0.0, 0.5);
    Eigen::MatrixXd K = covariance(data);
    K.diagonal() += variance;
    const Eigen::VectorXd x = Eigen::Vector2d(0.3, -0.2);
    Eigen::VectorXd k(30);
    for (Eigen::Index u = 0; u < 30; ++u) k[u] = kernel(data.X.row(u), x, data.hyper);
    const double prior = std::pow(data.hyper.signalSd, 2) + std::pow(data.hyper.noiseSd, 2);
    const GaussianProcess process(data.X, data.y, data.hyper, 0.0, {}, variance);
    EXPECT_NEAR(process.predict(x).mean, k.dot(K.llt().solve(data.y)), 1e-9);
    EXPECT_NEAR(process.predict(x).variance, prior - k.dot(K.llt().solve(k)), 1e-9);
    // Through all rows a sparse process is the same.
    const auto sparse = GaussianProcess::sparse(data.X, data.y, 29, data.hyper, 0.0, {}, variance);
    EXPECT_NEAR(sparse->predict(x).mean, process.predict(x).mean, 0.02);
    EXPECT_THROW(GaussianProcess(data.X, data.y, data.hyper, 0.0, {}, variance.head(29)),
                 std::invalid_argument);
    EXPECT_THROW(GaussianProcess(data.X, data.y, data.hyper, 0.0, {}, -variance),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
