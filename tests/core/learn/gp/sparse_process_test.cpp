#include "core/learn/gp/sparse_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/scene_conditional.h"
#include "tests/support/process_data.h"

namespace terratact {
namespace {

struct SparseData {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper{Eigen::Vector3d(1.5, 2.0, 4.0), 1.2, 0.2};

    explicit SparseData(Eigen::Index rows) : X(rows, 3), y(rows)
    {
        std::mt19937_64 rng(1);
        std::normal_distribution<double> normal;
        for (double& x : X.reshaped()) x = normal(rng);
        for (Eigen::Index u = 0; u < rows; ++u)
            y[u] = std::sin(X(u, 0)) + 0.5 * X(u, 1) + 0.2 * normal(rng);
    }
    double k(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const
    {
        return hyper.signalSd * hyper.signalSd
             * std::exp(-0.5 * (a - b).cwiseQuotient(hyper.lengthScale).squaredNorm());
    }
    Eigen::MatrixXd k(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) const
    {
        Eigen::MatrixXd K(A.rows(), B.rows());
        for (Eigen::Index i = 0; i < A.rows(); ++i)
            for (Eigen::Index j = 0; j < B.rows(); ++j)
                K(i, j) = k(Eigen::VectorXd(A.row(i)), Eigen::VectorXd(B.row(j)));
        return K;
    }
};

const std::vector<Eigen::Vector3d> kPlaces{
    {0.0, 0.0, 0.0}, {1.0, -0.5, 0.3}, {-2.0, 1.0, 1.0}, {8.0, 8.0, -8.0}};

TEST(SparseProcess, isTheFormulaOfItsHeader)
{
    const SparseData data(90);
    const SparseProcess p = sparseProcess(data.X, data.y, 12, data.hyper);
    ASSERT_EQ(p.inducing.size(), 12U);
    const Eigen::MatrixXd Z = data.X(p.inducing, Eigen::all);
    const Eigen::MatrixXd Kmm = data.k(Z, Z);
    const Eigen::MatrixXd Kmn = data.k(Z, data.X);
    const Eigen::MatrixXd inverse = inverseOf(Kmm.llt());
    const double signal2 = 1.44;
    const Eigen::VectorXd lambda =
        (signal2 + 0.04 - (Kmn.transpose() * inverse * Kmn).diagonal().array()).matrix();
    const Eigen::MatrixXd scaled = Kmn * lambda.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd inverseA =
        inverseOf(Eigen::LLT<Eigen::MatrixXd>(Kmm + scaled * Kmn.transpose()));
    const Eigen::VectorXd w = inverseA * scaled * data.y;
    EXPECT_LT((p.weights - w).norm(), 1e-8 * w.norm());
    const Eigen::MatrixXd difference = inverse - inverseA;
    EXPECT_LT((p.F.transpose() * p.F - difference).norm(), 1e-8 * difference.norm());
    EXPECT_EQ(p.F.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm(), 0.0);
}

TEST(SparseProcess, isTheExactOneWhereEveryRowInduces)
{
    SparseData data(40);
    data.hyper.lengthScale << 0.3, 0.4, 0.5;  // no row explains another
    const SparseProcess p = sparseProcess(data.X, data.y, 40, data.hyper);
    ASSERT_EQ(p.inducing.size(), 40U);
    const Eigen::MatrixXd Z = data.X(p.inducing, Eigen::all);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.0);
    for (const Eigen::Vector3d& x : kPlaces) {
        const Eigen::VectorXd k = data.k(Z, x.transpose());
        EXPECT_NEAR(k.dot(p.weights), exact.predict(x).mean, 1e-9);
        EXPECT_NEAR(1.44 + 0.04 - (p.F * k).squaredNorm(), exact.predict(x).variance, 1e-9);
    }
}

TEST(SparseProcess, choosesEachRowOnceAndStopsWhereRowsRepeat)
{
    SparseData data(60);
    const SparseProcess all = sparseProcess(data.X, data.y, 30, data.hyper);
    EXPECT_EQ(std::set<int>(all.inducing.begin(), all.inducing.end()).size(), 30U);
    EXPECT_EQ(all.inducing, sparseProcess(data.X, data.y, 30, data.hyper).inducing);
    for (Eigen::Index u = 10; u < 60; ++u) data.X.row(u) = data.X.row(u % 10);
    EXPECT_EQ(sparseProcess(data.X, data.y, 30, data.hyper).inducing.size(), 10U);
}

/// The covariance of all rows would be singular, although each row adds something; without the last
/// rows it is not.
TEST(SparseProcess, takesOnlyRowsThatKeepItWellConditioned)
{
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd X(900, 5);
    for (double& x : X.reshaped()) x = normal(rng);
    const Eigen::VectorXd y = X.col(0).array().sin();
    const Hyperparameters hyper{Eigen::VectorXd::Constant(5, 3.0), 1.2, 0.2};
    const SparseProcess p = sparseProcess(X, y, 850, hyper);
    EXPECT_GE(p.rcond, kMinRcond);
    EXPECT_GT(p.inducing.size(), 300U);
    EXPECT_LT(p.inducing.size(), 748U) << "so many were singular";
    const GaussianProcess exact(X, y, hyper, 0.0);
    const auto sparse = GaussianProcess::sparse(X, y, 850, hyper, 0.0);
    for (const double at : {0.0, 0.8, 2.0}) {
        const Eigen::VectorXd x = Eigen::VectorXd::Constant(5, at);
        EXPECT_NEAR(sparse->predict(x).mean, exact.predict(x).mean, 1e-4);
        EXPECT_NEAR(sparse->predict(x).variance, exact.predict(x).variance, 1e-4);
    }
}

/// Returns the largest difference of |F k_m|² from kᵀ (K + σ_n²)⁻¹ k, at rows and beside them. It
/// is a share of the variance.
double worstOf(const ReducedVariance& reduced, const SparseData& data)
{
    const double noise2 = data.hyper.noiseSd * data.hyper.noiseSd;
    Eigen::MatrixXd K = data.k(data.X, data.X);
    K.diagonal().array() += noise2;
    const Eigen::LLT<Eigen::MatrixXd> factor(K);
    double worst = 0.0;
    for (Eigen::Index u = 0; u < data.X.rows(); u += 3) {
        const Eigen::Vector3d x = data.X.row(u).transpose() * (u % 2 == 0 ? 1.0 : 1.2);
        const Eigen::VectorXd k = data.k(data.X, x.transpose());
        const double exact = k.dot(factor.solve(k));
        const double got = (reduced.F * k(reduced.rows)).squaredNorm();
        worst = std::max(worst, std::abs(got - exact) / (1.44 + noise2 - exact));
    }
    return worst;
}

TEST(ReducedVariance, equalsTheVarianceThroughAllRows)
{
    const SparseData data(400);
    const auto reduced = reducedVariance(data.X, data.hyper);
    ASSERT_TRUE(reduced);
    EXPECT_GT(reduced->rows.size(), 20U);
    EXPECT_LT(reduced->rows.size(), 300U);
    EXPECT_EQ(reduced->F.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm(), 0.0);
    EXPECT_LT(worstOf(*reduced, data), 2e-3);
    EXPECT_EQ(reduced->rows, reducedVariance(data.X, data.hyper)->rows);
}

TEST(ReducedVariance, isEmptyIfItSavesNothingOrCannotBeJudged)
{
    SparseData data(100);
    data.hyper.lengthScale << 0.1, 0.1, 0.1;  // no row explains another
    EXPECT_FALSE(reducedVariance(data.X, data.hyper));
    data = SparseData(400);
    for (const double noise : {0.0, 1e-300, 1e-3}) {
        data.hyper.noiseSd = noise;
        EXPECT_FALSE(reducedVariance(data.X, data.hyper)) << noise;
    }
    data.hyper.noiseSd = 1e3;  // almost nothing remains to explain
    EXPECT_FALSE(reducedVariance(data.X, data.hyper));
    data.hyper.signalSd = 1e-155;  // whose square is subnormal
    data.hyper.noiseSd = 1e-156;
    EXPECT_FALSE(reducedVariance(data.X, data.hyper));
    EXPECT_FALSE(reducedVariance(data.X.topRows(1), SparseData(1).hyper));
}

/// Rows around one place: none is worth choosing, but together they determine the slope there.
TEST(ReducedVariance, isEmptyIfRemainingRowsMatterTogether)
{
    const double perRow = 0.9 * kUnexplainedOfNoise * 0.2 * 0.2 / (1.2 * 1.2);  // of σ_f²
    const auto rows = [perRow](int count) {
        SparseData data(count);
        data.hyper.lengthScale.setConstant(1.0);
        data.X.setZero();
        for (int u = 1; u < count; ++u) data.X(u, 0) = (u % 2 == 0 ? 1 : -1) * std::sqrt(perRow);
        return data;
    };
    const auto few = reducedVariance(rows(100).X, rows(100).hyper);
    ASSERT_TRUE(few) << "these say 0.9 % of the noise";
    EXPECT_EQ(few->rows, std::vector<int>{0});
    EXPECT_FALSE(reducedVariance(rows(150).X, rows(150).hyper));
}

TEST(ReducedVariance, stopsAtEveryPoll)
{
    struct Stop {};
    const SparseData data(200);
    int polls = 0;
    (void)reducedVariance(data.X, data.hyper, [&] { ++polls; });
    EXPECT_GT(polls, 30);
    for (int last = 1; last <= polls; last += 3) {
        int left = last;
        EXPECT_THROW((void)reducedVariance(data.X, data.hyper,
                                           [&] {
                                               if (--left == 0) throw Stop{};
                                           }),
                     Stop);
    }
}

TEST(SparseGaussianProcess, comesCloseToTheExactOneAndCloserWithMoreRows)
{
    const SparseData data(300);
    const GaussianProcess exact(data.X, data.y, data.hyper, 0.5);
    double before = 2.0;
    for (const int m : {10, 30, 90}) {
        const auto sparse = GaussianProcess::sparse(data.X, data.y, m, data.hyper, 0.5);
        EXPECT_EQ(sparse->rows(), m);
        double worst = 0.0;
        for (Eigen::Index u = 0; u < 300; u += 7) {
            const Normal a = exact.predict(data.X.row(u).transpose());
            const Normal b = sparse->predict(data.X.row(u).transpose());
            worst = std::max({worst, std::abs(a.mean - b.mean),
                              std::abs(std::sqrt(a.variance) - std::sqrt(b.variance))});
        }
        EXPECT_LT(worst, 0.5 * before) << m;
        before = worst;
    }
    EXPECT_LT(before, 0.02);
    const auto whole = GaussianProcess::sparse(data.X, data.y, 300, data.hyper, 0.5);
    EXPECT_EQ(whole->predict(kPlaces[1]).mean, exact.predict(kPlaces[1]).mean);
}

TEST(SparseGaussianProcess, keepsItsVarianceBetweenTheNoiseAndThePrior)
{
    for (const double noise : {1e-6, 0.2, 50.0}) {
        SparseData data(200);
        data.hyper.noiseSd = noise;
        const auto sparse = GaussianProcess::sparse(data.X, data.y, 40, data.hyper, -1.0);
        for (const Eigen::Vector3d& x : kPlaces) {
            const Normal p = sparse->predict(x);
            EXPECT_TRUE(std::isfinite(p.mean));
            EXPECT_GE(p.variance, noise * noise);
            EXPECT_LE(p.variance, (1.44 + noise * noise) * (1.0 + 1e-12));
        }
        const Normal far = sparse->predict(Eigen::Vector3d(1e6, 1e6, 1e6));
        EXPECT_DOUBLE_EQ(far.mean, -1.0);
    }
}

TEST(SparseGaussianProcess, usesSinglePrecisionOnlyIfAccurate)
{
    SparseData data(300);
    Eigen::VectorXd single, exact, mean;
    for (const double noise : {1e-5, 0.2, 0.7}) {
        data.hyper.noiseSd = noise;
        const auto sparse = GaussianProcess::sparse(data.X, data.y, 60, data.hyper, 0.0);
        EXPECT_EQ(sparse->usable(Precision::Double), Precision::Double);
        EXPECT_EQ(sparse->usable(Precision::Single),
                  noise < 1e-3 ? Precision::Double : Precision::Single);
        for (const Eigen::Vector3d& x : kPlaces) {
            SceneConditional(*sparse, x, {1}, Precision::Single).predict(x.row(1), mean, single);
            SceneConditional(*sparse, x, {1}, Precision::Double).predict(x.row(1), mean, exact);
            EXPECT_NEAR(single[0], exact[0], 1e-2 * noise * noise);
        }
    }
}

TEST(SparseGaussianProcess, isBuiltOnlyIfEveryPollReturns)
{
    struct Stop {};
    const SparseData data(300);
    const auto built = [&](const Poll& poll) {
        return GaussianProcess::sparse(data.X, data.y, 60, data.hyper, 0.0, poll);
    };
    int polls = 0;
    (void)built([&] { ++polls; });
    EXPECT_GT(polls, 120);  // one for every pivot and every column
    for (int last = 1; last <= polls; last += 9) {
        int left = last;
        EXPECT_THROW((void)built([&] {
                         if (--left == 0) throw Stop{};
                     }),
                     Stop);
    }
}

TEST(SparseProcess, refusesASignalWhoseVarianceUnderflows)
{
    SparseData data(50);
    for (const double signalSd : {1e-200, 1e-155}) {
        data.hyper.signalSd = signalSd;
        EXPECT_THROW((void)sparseProcess(data.X, data.y, 5, data.hyper), std::invalid_argument);
    }
}

TEST(SparseProcess, refusesWhatItCannotLearnFrom)
{
    SparseData data(50);
    EXPECT_THROW((void)sparseProcess(data.X, data.y, 0, data.hyper), std::invalid_argument);
    EXPECT_THROW((void)sparseProcess(data.X, data.y.head(49), 5, data.hyper),
                 std::invalid_argument);
    data.X(1, 1) = std::nan("");
    EXPECT_THROW((void)sparseProcess(data.X, data.y, 5, data.hyper), std::invalid_argument);
    data.X(1, 1) = 1e200;
    data.hyper.lengthScale[1] = 1e-200;
    EXPECT_THROW((void)sparseProcess(data.X, data.y, 5, data.hyper), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
