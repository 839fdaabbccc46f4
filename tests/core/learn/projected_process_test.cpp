#include "core/learn/projected_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/learn/gaussian_process.h"

namespace terratact {
namespace {

struct Data {
    Eigen::MatrixXd X{60, 2};
    Eigen::VectorXd y{60};
    Hyperparameters hyper{Eigen::Vector2d(0.8, 1.5), 1.2, 0.2};
    std::vector<int> all = std::vector<int>(60);

    Data()
    {
        std::mt19937_64 rng(1);
        std::normal_distribution<double> normal;
        for (double& x : X.reshaped()) x = normal(rng);
        for (Eigen::Index u = 0; u < 60; ++u)
            y[u] = std::sin(2.0 * X(u, 0)) + X(u, 1) + 0.2 * normal(rng);
        std::iota(all.begin(), all.end(), 0);
    }
    double mean(const ProjectedProcess& p, const std::vector<int>& inducing,
                const Eigen::Vector2d& x) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < inducing.size(); ++k) {
            const Eigen::Vector2d d =
                (X.row(inducing[k]).transpose() - x).cwiseQuotient(hyper.lengthScale);
            sum += p.weights[static_cast<Eigen::Index>(k)] * hyper.signalSd * hyper.signalSd
                 * std::exp(-0.5 * d.squaredNorm());
        }
        return sum;
    }
};

TEST(ProjectedProcess, isTheExactProcessWhereAllRowsInduce)
{
    const Data data;
    const ProjectedProcess p = projectProcess(data.X, data.y, data.all, data.hyper);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.0);
    for (const double at : {-1.0, 0.0, 0.7}) {
        const Eigen::Vector2d x(at, 0.5 * at);
        EXPECT_NEAR(data.mean(p, data.all, x), exact.predict(x).mean, 1e-4) << at;
    }
}

TEST(ProjectedProcess, leavesOneOut)
{
    const Data data;
    const ProjectedProcess p = projectProcess(data.X, data.y, data.all, data.hyper);
    for (const int u : {0, 17, 59}) {
        std::vector<int> others = data.all;
        others.erase(others.begin() + u);
        const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0);
        const double expected = data.y[u] - without.predict(data.X.row(u).transpose()).mean;
        EXPECT_NEAR(p.leaveOneOut[u], expected, 2e-3) << u;
    }
}

TEST(ProjectedProcess, predictsWellThroughFewRows)
{
    const Data data;
    std::vector<int> some;
    for (int u = 0; u < 60; u += 2) some.push_back(u);
    const ProjectedProcess p = projectProcess(data.X, data.y, some, data.hyper);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.0);
    double square = 0.0;
    for (Eigen::Index u = 0; u < 60; ++u) {
        const Eigen::Vector2d x = data.X.row(u).transpose();
        square += std::pow(data.mean(p, some, x) - exact.predict(x).mean, 2.0) / 60.0;
    }
    EXPECT_LT(std::sqrt(square), 0.15);
}

TEST(ProjectedProcess, ofDoubledRowsIsThatOfTheirMeansWithHalfTheNoiseVariance)
{
    Data once;
    Data twice;
    once.y[5] += 0.3;
    twice.X.conservativeResize(120, Eigen::NoChange);
    twice.X.bottomRows(60) = once.X;
    twice.y.conservativeResize(120);
    twice.y.head(60) = once.y.array() + 0.1;
    twice.y.tail(60) = once.y.array() - 0.1;
    once.hyper.noiseSd /= std::sqrt(2.0);
    std::vector<int> all(120);
    std::iota(all.begin(), all.end(), 0);
    const ProjectedProcess p = projectProcess(twice.X, twice.y, all, twice.hyper);
    EXPECT_GE(p.rcond, kLeastRcond);
    EXPECT_LE(p.rcond, 1e-6);  // the inducing rows repeat: the jitter is all that tells them apart
    const GaussianProcess exact(once.X, once.y, once.hyper, 0.0);
    for (const double at : {-1.0, 0.0, 0.7}) {
        const Eigen::Vector2d x(at, 0.5 * at);
        EXPECT_NEAR(twice.mean(p, all, x), exact.predict(x).mean, 1e-4) << at;
    }
}

/// Long double and the header's formulas: the mean's weights times covariances, at the rows.
Eigen::VectorXd fittedInLongDouble(const Data& data)
{
    using Long = long double;
    using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
    const Eigen::Index n = data.X.rows();
    const Long signal2 = static_cast<Long>(data.hyper.signalSd) * data.hyper.signalSd;
    const Long noise2 = static_cast<Long>(data.hyper.noiseSd) * data.hyper.noiseSd;
    Matrix K(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            K(i, j) = signal2
                    * std::exp(-0.5L
                               * (data.X.row(i) - data.X.row(j))
                                     .cast<Long>()
                                     .cwiseQuotient(data.hyper.lengthScale.transpose().cast<Long>())
                                     .squaredNorm());
    Matrix A = K * K / noise2 + K;
    A.diagonal().array() += static_cast<Long>(kProjectionJitter) * signal2;
    return (K * A.ldlt().solve(K * data.y.cast<Long>() / noise2)).cast<double>();
}

TEST(ProjectedProcess, atTheExtremesIsRightOrRefused)
{
    int right = 0, refused = 0;
    for (const double length : {1e-8, 1e-3, 1.0, 1e3, 1e8})
        for (const double offset :
             {0.0, 1e8})  // of an input, where |a|² − 2 a·b + |b|² would cancel
            for (const double signal : {1e-160, 1e-12, 0.3, 1e6})
                for (const double noise : {1e-12, 1e-3, 0.2, 1e6}) {
                    Data data;
                    data.X.col(0).array() += offset;
                    data.hyper = {Eigen::Vector2d::Constant(length), signal, noise};
                    ProjectedProcess p;
                    try {
                        p = projectProcess(data.X, data.y, data.all, data.hyper);
                    } catch (const std::invalid_argument& why) {
                        EXPECT_GT(std::string(why.what()).size(), 30U);
                        ++refused;
                        continue;
                    }
                    ++right;
                    ASSERT_TRUE(p.weights.allFinite() && p.leaveOneOut.allFinite());
                    EXPECT_GE(p.rcond, kLeastRcond);
                    const Eigen::VectorXd expected = fittedInLongDouble(data);
                    for (const int u : {0, 17, 59})
                        EXPECT_NEAR(data.mean(p, data.all, data.X.row(u).transpose()), expected[u],
                                    1e-4 * data.y.cwiseAbs().maxCoeff())
                            << "l " << length << ", offset " << offset << ", sf " << signal
                            << ", sn " << noise << ", rcond " << p.rcond;
                }
    EXPECT_GT(right, 80);
    EXPECT_GT(refused, 10);
    std::cout << right << " right, " << refused << " refused\n";
}

TEST(ProjectedProcess, refusesWhatItCannotLearnFrom)
{
    Data data;
    EXPECT_THROW((void)projectProcess(data.X, data.y, {}, data.hyper), std::invalid_argument);
    EXPECT_THROW((void)projectProcess(data.X, data.y, {60}, data.hyper), std::invalid_argument);
    EXPECT_THROW((void)projectProcess(data.X, data.y.head(5), data.all, data.hyper),
                 std::invalid_argument);
    data.y[3] = std::nan("");
    EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper), std::invalid_argument);
    data = Data();
    data.hyper.noiseSd = 0.0;
    EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
