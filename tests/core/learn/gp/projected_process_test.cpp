#include "core/learn/gp/projected_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/learn/gp/gaussian_process.h"
#include "tests/support/extreme_data.h"

namespace terratact {
namespace {

struct ProjectedData {
    Eigen::MatrixXd X{60, 2};
    Eigen::VectorXd y{60};
    Hyperparameters hyper{Eigen::Vector2d(0.8, 1.5), 1.2, 0.2};
    std::vector<int> all = std::vector<int>(60);

    ProjectedData()
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
    const ProjectedData data;
    const ProjectedProcess p = projectProcess(data.X, data.y, data.all, data.hyper);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.0);
    for (const double at : {-1.0, 0.0, 0.7}) {
        const Eigen::Vector2d x(at, 0.5 * at);
        EXPECT_NEAR(data.mean(p, data.all, x), exact.predict(x).mean, 1e-4) << at;
    }
}

TEST(ProjectedProcess, leavesOneOut)
{
    const ProjectedData data;
    const ProjectedProcess p = projectProcess(data.X, data.y, data.all, data.hyper);
    for (const int u : {0, 17, 59}) {
        std::vector<int> others = data.all;
        others.erase(others.begin() + u);
        const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0);
        const double expected = data.y[u] - without.predict(data.X.row(u).transpose()).mean;
        EXPECT_NEAR(p.leaveOneOut[u], expected, 2e-3) << u;
    }
}

TEST(ProjectedProcess, leavesOutAllRowsOfAPlace)
{
    const ProjectedData data;
    std::vector<int> places = data.all;
    for (const int u : {17, 18, 19, 59}) places[static_cast<std::size_t>(u)] = 17;
    const ProjectedProcess p = projectProcess(data.X, data.y, data.all, data.hyper, {}, places);
    std::vector<int> others;
    for (const int u : data.all)
        if (places[static_cast<std::size_t>(u)] != 17) others.push_back(u);
    const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0);
    for (const int u : {17, 18, 19, 59}) {
        const double expected = data.y[u] - without.predict(data.X.row(u).transpose()).mean;
        EXPECT_NEAR(p.leaveOneOut[u], expected, 2e-3) << u;
    }
    const ProjectedProcess alone = projectProcess(data.X, data.y, data.all, data.hyper);
    EXPECT_EQ(p.leaveOneOut[5], alone.leaveOneOut[5]);
    EXPECT_EQ(p.weights, alone.weights);
}

TEST(ProjectedProcess, predictsWellThroughFewRows)
{
    const ProjectedData data;
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

TEST(ProjectedProcess, repeatedRowsEqualTheirMeanWithHalfTheNoise)
{
    ProjectedData once;
    ProjectedData twice;
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
    EXPECT_GE(p.rcond, kMinRcond);
    EXPECT_LE(p.rcond, 1e-6);  // the inducing rows repeat: only the jitter separates them
    const GaussianProcess exact(once.X, once.y, once.hyper, 0.0);
    for (const double at : {-1.0, 0.0, 0.7}) {
        const Eigen::Vector2d x(at, 0.5 * at);
        EXPECT_NEAR(twice.mean(p, all, x), exact.predict(x).mean, 1e-4) << at;
    }
}

/// The header's formulas in long double, at every row.
struct LongProjection {
    Eigen::VectorXd mean, leaveOneOut, freedom;  ///< freedom: 1 − H_uu
};

LongProjection inLongDouble(const ExtremeData& data, const std::vector<int>& inducing)
{
    const Eigen::MatrixXd Z = data.X(inducing, Eigen::all);
    const Long noise2 = squareOf(data.hyper.noiseSd);
    const LongMatrix Kmn = covarianceOf(Z, data.X, data.hyper);
    LongMatrix Kmm = covarianceOf(Z, Z, data.hyper);
    Kmm.diagonal().array() += static_cast<Long>(kProjectionJitter) * squareOf(data.hyper.signalSd);
    // This form of A = L (1 + V Vᵀ) Lᵀ needs no more digits than these.
    const Eigen::LLT<LongMatrix> outer(Kmm);
    const LongMatrix V = outer.matrixL().solve(Kmn) / std::sqrt(noise2);
    const Eigen::LLT<LongMatrix> inner(LongMatrix::Identity(Z.rows(), Z.rows())
                                       + V * V.transpose());
    const LongVector y = data.y.cast<Long>();
    const LongMatrix solved = inner.solve(V);
    const LongVector mean = V.transpose() * (solved * y);
    const LongVector freedom = 1.0L - V.cwiseProduct(solved).colwise().sum().transpose().array();
    const LongVector least = freedom.cwiseMax(static_cast<Long>(kMinFreedom));
    return {mean.cast<double>(), (y - mean).cwiseQuotient(least).cast<double>(),
            freedom.cast<double>()};
}

double meanAt(const ExtremeData& data, const std::vector<int>& inducing, const ProjectedProcess& p,
              const Eigen::VectorXd& x)
{
    const Eigen::MatrixXd Z = data.X(inducing, Eigen::all);
    return p.weights.dot(covarianceWith(Z, x, data.hyper).cast<double>());
}

/// Results of all projections at the extremes.
struct ProjectionTally {
    int right = 0, exact = 0, refused = 0;
    double worst = 0.0;

    void add(const ExtremeData& data, const std::vector<int>& inducing, const std::string& what)
    {
        ProjectedProcess p;
        try {
            p = projectProcess(data.X, data.y, inducing, data.hyper);
        } catch (const std::invalid_argument& why) {
            EXPECT_GT(std::string(why.what()).size(), 30U);
            ++refused;
            return;
        }
        ++right;
        exact += p.errorBound() == 1e-9;
        ASSERT_TRUE(p.weights.allFinite() && p.leaveOneOut.allFinite()) << what;
        EXPECT_GE(p.rcond, kMinRcond) << what;
        EXPECT_LE(p.errorBound(), 1.0001e-2) << what;
        const LongProjection expected = inLongDouble(data, inducing);
        const double share = p.errorBound();
        const double bound = share * data.y.cwiseAbs().maxCoeff();
        for (Eigen::Index u = 0; u < data.X.rows(); ++u) {
            const double mean = meanAt(data, inducing, p, data.X.row(u).transpose());
            EXPECT_NEAR(mean, expected.mean[u], bound) << what;
            const double least = std::max(expected.freedom[u] - share, kMinFreedom);
            const double ofResidual = (bound + share * std::abs(expected.leaveOneOut[u])) / least;
            EXPECT_NEAR(p.leaveOneOut[u], expected.leaveOneOut[u], ofResidual) << what;
            if (share == 1e-9) continue;
            worst = std::max({worst, std::abs(mean - expected.mean[u]) / bound,
                              std::abs(p.leaveOneOut[u] - expected.leaveOneOut[u]) / ofResidual});
        }
    }
};

std::vector<int> everyRow(Eigen::Index rows, int step)
{
    std::vector<int> chosen;
    for (int u = 0; u < rows; u += step) chosen.push_back(u);
    return chosen;
}

TEST(ProjectedProcess, atTheExtremesIsRightOrRefused)
{
    ProjectionTally tally;
    for (const Kind kind : kKinds)
        for (const int U : {1, 2, 40})
            for (const int step : {1, 3})
                forEveryScale(kind, U, [&](const ExtremeData& data, const std::string& what) {
                    tally.add(data, everyRow(U, step), what + ", every " + std::to_string(step));
                });
    for (const double length : {1e-3, 1.0, 1e3})  // where |a|² − 2 a·b + |b|² would cancel
        for (const double noise : {1e-3, 0.2}) {
            ExtremeData data = dataOf(Kind::Plain, 40, length, 0.3, noise);
            data.X.col(0).array() += 1e8;
            tally.add(data, everyRow(40, 1), "far off");
        }
    std::cout << tally.right << " right, " << tally.exact << " of them to 1e-9, " << tally.refused
              << " refused; errors up to " << tally.worst
              << " of the bound where the condition decides\n";
    EXPECT_GT(tally.right, 600);
    EXPECT_GT(tally.exact, 300);
    EXPECT_GT(tally.refused, 10);
}

TEST(ProjectedProcess, ofAModelsSizeIsRight)
{
    const int rows = manyRows(1400);
    ProjectionTally tally;
    for (const Kind kind : {Kind::Plain, Kind::Collinear, Kind::ConstantColumn})
        tally.add(dataOf(kind, rows, 1.0, 0.3, 0.05), everyRow(rows, 8), "many rows");
    EXPECT_EQ(tally.right, 3);
    std::cout << rows << " rows, errors up to " << tally.worst << " of the bound\n";
}

TEST(ProjectedProcess, rowAt1e200ChangesNothingElsewhere)
{
    const ExtremeData plain = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
    ExtremeData far = withFarRow(plain);
    const std::vector<int> twenty = everyRow(20, 1), all = everyRow(21, 1);
    const ProjectedProcess without = projectProcess(plain.X, plain.y, twenty, plain.hyper);
    const ProjectedProcess with = projectProcess(far.X, far.y, all, far.hyper);
    const Eigen::Vector3d x(0.1, 0.2, 0.3);
    EXPECT_NEAR(meanAt(far, all, with, x), meanAt(plain, twenty, without, x), 1e-12);
    EXPECT_TRUE(with.leaveOneOut.allFinite());
    far.hyper.lengthScale[0] = 1e-200;  // that of its input overflows
    EXPECT_THROW((void)projectProcess(far.X, far.y, all, far.hyper), std::invalid_argument);
}

TEST(ProjectedProcess, refusesWhatItCannotLearnFrom)
{
    ProjectedData data;
    EXPECT_THROW((void)projectProcess(data.X, data.y, {}, data.hyper), std::invalid_argument);
    EXPECT_THROW((void)projectProcess(data.X, data.y, {60}, data.hyper), std::invalid_argument);
    EXPECT_THROW((void)projectProcess(data.X, data.y.head(5), data.all, data.hyper),
                 std::invalid_argument);
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        data.y[3] = bad;
        EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper),
                     std::invalid_argument);
        data = ProjectedData();
        data.X(7, 1) = bad;
        EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper),
                     std::invalid_argument);
        data = ProjectedData();
        data.hyper.lengthScale[1] = bad;
        EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper),
                     std::invalid_argument);
        data = ProjectedData();
    }
    data.hyper.noiseSd = 0.0;
    EXPECT_THROW((void)projectProcess(data.X, data.y, data.all, data.hyper), std::invalid_argument);
}

TEST(ProjectedProcess, weighsRowsByTheirVariance)
{
    const ProjectedData data;
    const Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(60, 0.0, 2.0);
    const ProjectedProcess p =
        projectProcess(data.X, data.y, data.all, data.hyper, {}, {}, variance);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.0, {}, variance);
    for (const double at : {-1.0, 0.0, 0.7}) {
        const Eigen::Vector2d x(at, 0.5 * at);
        EXPECT_NEAR(data.mean(p, data.all, x), exact.predict(x).mean, 1e-4) << at;
    }
    // The residual of a row is that against the process without it.
    for (const int left : {3, 50}) {
        std::vector<int> others;
        for (int u = 0; u < 60; ++u)
            if (u != left) others.push_back(u);
        const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0,
                                      {}, variance(others));
        EXPECT_NEAR(p.leaveOneOut[left],
                    data.y[left] - without.predict(data.X.row(left).transpose()).mean, 2e-3);
    }
}

TEST(ProjectedProcess, leavesOutPlacesOfNoisyRows)
{
    const ProjectedData data;
    const Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(60, 0.0, 2.0);
    std::vector<int> places = data.all;
    places[21] = 20;
    const ProjectedProcess p =
        projectProcess(data.X, data.y, data.all, data.hyper, {}, places, variance);
    std::vector<int> others;
    for (int u = 0; u < 60; ++u)
        if (u != 20 && u != 21) others.push_back(u);
    const GaussianProcess without(data.X(others, Eigen::all), data.y(others), data.hyper, 0.0, {},
                                  variance(others));
    for (const int u : {20, 21})
        EXPECT_NEAR(p.leaveOneOut[u], data.y[u] - without.predict(data.X.row(u).transpose()).mean,
                    2e-3);
}

}  // namespace
}  // namespace terratact
