#include "core/learn/gp/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "tests/support/process_data.h"

namespace terratact {
namespace {

Eigen::MatrixXd randomMatrix(int rows, int columns, unsigned seed)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd A(rows, columns);
    for (double& x : A.reshaped()) x = normal(rng);
    return A;
}

/// Returns a positive definite matrix of full rank, with eigenvalues from about `least` to about 4
/// n.
Eigen::MatrixXd positiveMatrix(int n, double least, unsigned seed = 1)
{
    const Eigen::MatrixXd A = randomMatrix(n, std::max(1, n / 2), seed);
    Eigen::MatrixXd K = A * A.transpose();
    K.diagonal().array() += least;
    return K;
}

double norm1(const Eigen::MatrixXd& K)
{
    return K.cwiseAbs().colwise().sum().maxCoeff();
}

TEST(Cholesky, givesFactorAndInverseAroundEveryBlockBorder)
{
    for (const int n : {1, 2, 127, 128, 129, 255, 256, 300}) {
        const Eigen::MatrixXd K = positiveMatrix(n, 1.0);
        Eigen::MatrixXd R = K;
        R.triangularView<Eigen::StrictlyLower>().setConstant(1e300);  // must not be read
        ASSERT_TRUE(choleskyUpper(R));
        const Eigen::MatrixXd upper = R.triangularView<Eigen::Upper>();
        EXPECT_LT((upper.transpose() * upper - K).cwiseAbs().maxCoeff(), 1e-12 * norm1(K)) << n;
        invertUpper(R);
        const Eigen::MatrixXd inverse = R.triangularView<Eigen::Upper>();
        EXPECT_LT((inverse * upper - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-11)
            << n;
        if (n > 1) {
            EXPECT_EQ(R(n - 1, 0), 1e300);
        }
    }
}

TEST(Cholesky, solvesSeveralColumnsAroundABlockBorder)
{
    for (const int n : {1, 300, 1024, 1100}) {
        Eigen::MatrixXd R = positiveMatrix(n, 1.0);
        ASSERT_TRUE(choleskyUpper(R));
        const Eigen::MatrixXd upper = R.triangularView<Eigen::Upper>();
        const Eigen::MatrixXd solution = randomMatrix(n, 16, 5);
        Eigen::MatrixXd B = upper.transpose() * solution;
        int polls = 0;
        solveTransposed(R, B, [&] { ++polls; });
        EXPECT_LT((B - solution).cwiseAbs().maxCoeff(), 1e-9) << n;
        EXPECT_EQ(polls, n > 1024 ? 3 : 1);
    }
}

TEST(Cholesky, failsForIndefiniteMatricesAndNan)
{
    for (const int n : {3, 128, 200}) {
        Eigen::MatrixXd K = positiveMatrix(n, 1.0);
        K(n - 1, n - 1) = -1.0;
        EXPECT_FALSE(choleskyUpper(K));
        for (const double bad : {std::nan(""), HUGE_VAL}) {
            K = positiveMatrix(n, 1.0);
            K(0, n - 1) = bad;
            EXPECT_FALSE(choleskyUpper(K)) << bad;
        }
    }
}

TEST(ReciprocalCondition, isAtLeastTheTruthAndSeldomFarAbove)
{
    int far = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Eigen::MatrixXd K = positiveMatrix(60, std::pow(10.0, -0.2 * seed), seed);
        const double exact = 1.0 / (norm1(K) * norm1(inverseOf(K.llt())));
        Eigen::MatrixXd R = K;
        ASSERT_TRUE(choleskyUpper(R));
        const double estimate = reciprocalCondition(R, norm1(K));
        EXPECT_GE(estimate, exact * (1.0 - 1e-4));
        far += estimate > 3.0 * exact;
    }
    EXPECT_LE(far, 1);
}

TEST(ReciprocalCondition, isZeroWhereTheInverseOverflows)
{
    const Eigen::MatrixXd R = Eigen::Vector3d(1.0, 1e-200, 1.0).asDiagonal();
    EXPECT_EQ(reciprocalCondition(R, 1.0), 0.0);
}

TEST(SymmetricNorm, isTheLargestColumnSumOfTheUpperTriangle)
{
    Eigen::MatrixXd K = positiveMatrix(30, 1.0) - Eigen::MatrixXd::Constant(30, 30, 2.0);
    const double expected = norm1(K);
    K.triangularView<Eigen::StrictlyLower>().setConstant(1e300);
    EXPECT_NEAR(symmetricNorm(K), expected, 1e-12 * expected);
}

TEST(Cholesky, stopsWhereverThePollThrows)
{
    struct Stop {};
    const Eigen::MatrixXd K = positiveMatrix(300, 1.0);
    int polls = 0;
    const auto run = [&](int last) {
        int left = last;
        const Poll poll = [&] {
            ++polls;
            if (--left == 0) throw Stop{};
        };
        Eigen::MatrixXd R = K;
        (void)choleskyUpper(R, poll);
        (void)reciprocalCondition(R, norm1(K), poll);
        invertUpper(R, poll);
    };
    run(-1);
    const int all = polls;
    EXPECT_GT(all, 10);
    for (int last = 1; last <= all; ++last) EXPECT_THROW(run(last), Stop) << last;
}

}  // namespace
}  // namespace terratact
