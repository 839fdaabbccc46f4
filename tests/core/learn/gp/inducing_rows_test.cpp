#include "core/learn/gp/inducing_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "core/learn/kernels/covariance_block.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {
namespace {

constexpr double kSignal2 = 1.7;

ScaledRows someRows(Eigen::Index n, Eigen::Index d, double spread = 1.0)
{
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd X(n, d);
    for (double& x : X.reshaped()) x = 0.7 * spread * normal(rng);
    return {X, Eigen::RowVectorXd::Ones(d)};
}

Eigen::MatrixXd covariance(const ScaledRows& X)
{
    Eigen::MatrixXd K(X.X.rows(), X.X.rows());
    for (Eigen::Index u = 0; u < K.cols(); ++u)
        K.col(u) = covarianceColumn(X, X.X.row(u), kSignal2);
    return K;
}

/// Variances of all rows given some of them.
Eigen::VectorXd given(const Eigen::MatrixXd& K, const std::vector<int>& rows)
{
    const Eigen::MatrixXd Kmn = K(rows, Eigen::all);
    const Eigen::MatrixXd Kmm = Kmn(Eigen::all, rows);
    return K.diagonal() - (Kmn.transpose() * Kmm.llt().solve(Kmn)).diagonal();
}

TEST(InducingRows, haveTheLargestRemainingVarianceOrAShareOfIt)
{
    const ScaledRows X = someRows(150, 4);
    const Eigen::MatrixXd K = covariance(X);
    for (const double share : {1.0, 0.6, 0.3}) {
        const RowsWanted wanted{.most = 60, .share = share};
        const InducingRows chosen = chooseInducingRows(X, kSignal2, wanted);
        ASSERT_EQ(chosen.rows.size(), 60U);
        EXPECT_EQ(chosen.rows[0], 0) << "the first of equals";
        double least = 1.0;
        for (std::size_t j = 1; j < chosen.rows.size(); ++j) {
            const std::vector<int> before(chosen.rows.begin(),
                                          chosen.rows.begin() + static_cast<std::ptrdiff_t>(j));
            const Eigen::VectorXd left = given(K, before);
            EXPECT_GE(left[chosen.rows[j]], share * left.maxCoeff() - 1e-10) << j;
            least = std::min(least, left[chosen.rows[j]] / left.maxCoeff());
        }
        if (share < 1.0) {
            EXPECT_LT(least, 0.5 + 0.5 * share);
        }
        EXPECT_NEAR(chosen.left, given(K, chosen.rows).maxCoeff(), 1e-10);
        EXPECT_EQ(chosen.rows, chooseInducingRows(X, kSignal2, wanted).rows);
    }
}

TEST(InducingRows, stopHalfwayIfTooMuchIsLeft)
{
    const ScaledRows X = someRows(150, 4);
    const double halfway = chooseInducingRows(X, kSignal2, {.most = 30}).left;
    const auto count = [&](double most) {
        return chooseInducingRows(X, kSignal2, {.most = 60, .mostHalfway = most}).rows.size();
    };
    EXPECT_EQ(count(0.999 * halfway), 30U);
    EXPECT_EQ(count(1.001 * halfway), 60U);
}

TEST(InducingRows, comeWithFactorAndProjection)
{
    const ScaledRows X = someRows(150, 4);
    const Eigen::MatrixXd K = covariance(X);
    for (const double share : {1.0, 0.3}) {
        const InducingRows chosen = chooseInducingRows(X, kSignal2, {.most = 70, .share = share});
        const Eigen::MatrixXd L = factorOf(chosen);
        EXPECT_LT((L * L.transpose() - K(chosen.rows, chosen.rows)).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_EQ(L.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm(), 0.0);
        EXPECT_LT((chosen.V * L.transpose() - K(Eigen::all, chosen.rows)).cwiseAbs().maxCoeff(),
                  1e-12);
        EXPECT_LT((chosen.V(chosen.rows, Eigen::all) - L).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(InducingRows, areAsManyAsExplainTheOthers)
{
    const ScaledRows X = someRows(200, 3);
    const Eigen::MatrixXd K = covariance(X);
    std::vector<std::size_t> counts;
    for (const double share : {1.0, 0.3}) {
        const InducingRows chosen =
            chooseInducingRows(X, kSignal2, {.most = 200, .leastVariance = 1e-3, .share = share});
        EXPECT_LE(chosen.left, 1e-3);
        EXPECT_LE(given(K, chosen.rows).maxCoeff(), 1e-3 + 1e-9);
        const std::vector<int> fewer(chosen.rows.begin(), chosen.rows.end() - 1);
        EXPECT_GT(given(K, fewer).maxCoeff(), 1e-3 - 1e-9);
        counts.push_back(chosen.rows.size());
        EXPECT_EQ(std::set<int>(chosen.rows.begin(), chosen.rows.end()).size(), counts.back());
    }
    EXPECT_LT(counts[0], 150U);
    EXPECT_LE(static_cast<double>(counts[1]), 1.1 * static_cast<double>(counts[0]));
}

TEST(InducingRows, areFewerForRepeatedAndAllForUnrelatedRows)
{
    ScaledRows X = someRows(60, 3);
    for (Eigen::Index u = 10; u < 60; ++u) X.X.row(u) = X.X.row(u % 10);
    EXPECT_EQ(chooseInducingRows(X, kSignal2, {.most = 60, .leastVariance = 1e-8, .share = 0.5})
                  .rows.size(),
              10U);
    const InducingRows all = chooseInducingRows(someRows(60, 3, 1e4), kSignal2,
                                                {.most = 60, .leastVariance = 1e-8, .share = 0.5});
    EXPECT_EQ(all.rows.size(), 60U);
    EXPECT_EQ(all.left, 0.0);
    EXPECT_EQ(chooseInducingRows(X, kSignal2, {.most = 60, .leastVariance = 2.0}).rows.size(), 0U);
    EXPECT_DOUBLE_EQ(chooseInducingRows(X, kSignal2, {.most = 60, .leastVariance = 2.0}).left,
                     kSignal2);
}

TEST(InducingRows, stopAtEveryPoll)
{
    struct Stop {};
    const ScaledRows X = someRows(200, 3);
    const auto choose = [&](const Poll& poll) {
        return factorOf(chooseInducingRows(X, kSignal2, {.most = 80, .share = 0.5}, poll), poll);
    };
    int polls = 0;
    (void)choose([&] { ++polls; });
    EXPECT_GT(polls, 80);
    for (int last = 1; last <= polls; ++last) {
        int left = last;
        EXPECT_THROW((void)choose([&] {
                         if (--left == 0) throw Stop{};
                     }),
                     Stop);
    }
}

TEST(CovarianceBlock, hasTheFormulasCovariancesForUpToEightColumns)
{
    ScaledRows X = someRows(21, 5);
    X.perLength << 0.1, 0.5, 1.0, 2.0, 3.0;
    const Eigen::MatrixXd K = covariance(X);
    CovarianceBlock block(X, kSignal2);
    for (const std::vector<int>& columns :
         {std::vector<int>{20}, {3, 0, 7}, {1, 2, 3, 4, 5, 6, 7, 8}}) {
        const int rows = 21 - static_cast<int>(columns.size());
        const double* got = block.with(columns, rows);
        for (std::size_t c = 0; c < columns.size(); ++c)
            for (int u = 0; u < rows; ++u)
                EXPECT_NEAR(got[static_cast<std::size_t>(u) * kGroup + c], K(u, columns[c]), 1e-14);
    }
}

TEST(CovarianceBlock, lengthScalesThatOverflowAreRefused)
{
    Eigen::MatrixXd X = someRows(3, 2).X;
    Hyperparameters hyper{Eigen::Vector2d(1.0, 1e-300), 1.0, 0.1};
    EXPECT_DOUBLE_EQ(inLengthScales(X, hyper).perLength[1], 1e300);
    X(2, 1) = 1e200;
    EXPECT_THROW((void)inLengthScales(X, hyper), std::invalid_argument);
    X(2, 1) = 0.0;
    hyper.lengthScale[1] = 1e-310;
    EXPECT_THROW((void)inLengthScales(X, hyper), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
