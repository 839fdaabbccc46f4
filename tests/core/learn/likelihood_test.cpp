#include "core/learn/likelihood.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace terratact {
namespace {

struct Data {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper;
};

Data someData(int U, int d, unsigned seed = 1)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    Data data{Eigen::MatrixXd(U, d), Eigen::VectorXd(U), {}};
    for (double& x : data.X.reshaped()) x = normal(rng);
    for (int u = 0; u < U; ++u) data.y[u] = std::sin(data.X(u, 0)) + 0.1 * normal(rng);
    data.hyper.lengthScale = Eigen::VectorXd::LinSpaced(d, 0.7, 2.5);
    data.hyper.signalSd = 0.9;
    data.hyper.noiseSd = 0.15;
    return data;
}

double kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Hyperparameters& h)
{
    return h.signalSd * h.signalSd
         * std::exp(-0.5 * (a - b).cwiseQuotient(h.lengthScale).squaredNorm());
}

Eigen::MatrixXd covariance(const Data& data)
{
    const Eigen::Index U = data.X.rows();
    Eigen::MatrixXd K(U, U);
    for (Eigen::Index i = 0; i < U; ++i)
        for (Eigen::Index j = 0; j < U; ++j)
            K(i, j) = kernel(data.X.row(i), data.X.row(j), data.hyper)
                    + (i == j ? data.hyper.noiseSd * data.hyper.noiseSd : 0.0);
    return K;
}

TEST(Likelihood, isTheLogDensityOfTheOutputs)
{
    const Data data = someData(40, 3);
    const Eigen::MatrixXd K = covariance(data);
    const Eigen::LLT<Eigen::MatrixXd> llt(K);
    const Eigen::MatrixXd L = llt.matrixL();
    const double expected = 0.5 * data.y.dot(llt.solve(data.y)) + L.diagonal().array().log().sum()
                          + 20.0 * std::log(2.0 * std::numbers::pi);
    EXPECT_NEAR(negativeLogLikelihood(data.X, data.y, data.hyper).negativeLog, expected,
                1e-10 * std::abs(expected));
}

TEST(Likelihood, gradientIsTheSlopeOfTheValue)
{
    const Data data = someData(50, 4);
    const Likelihood at = negativeLogLikelihood(data.X, data.y, data.hyper);
    ASSERT_EQ(at.gradient.size(), 6);
    constexpr double h = 1e-5;
    for (Eigen::Index k = 0; k < 6; ++k) {
        const auto shifted = [&](double by) {
            Hyperparameters p = data.hyper;
            double& value = k < 4 ? p.lengthScale[k] : (k == 4 ? p.signalSd : p.noiseSd);
            value *= std::exp(by);
            return negativeLogLikelihood(data.X, data.y, p).negativeLog;
        };
        const double slope = (shifted(h) - shifted(-h)) / (2.0 * h);
        EXPECT_NEAR(at.gradient[k], slope, 1e-6 * (1.0 + std::abs(slope))) << "parameter " << k;
    }
}

}  // namespace
}  // namespace terratact
