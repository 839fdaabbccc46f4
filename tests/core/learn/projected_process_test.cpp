#include "core/learn/projected_process.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <stdexcept>

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
