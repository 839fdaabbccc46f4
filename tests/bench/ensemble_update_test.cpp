// Tests the ensemble Kalman update against the closed form of the linear Gaussian case.
#include "tests/bench/ensemble_update.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

constexpr Eigen::Index kMembers = 20000;

/// A state of three numbers, of which two readings see sums.
struct EnsembleUpdate : testing::Test {
    EnsembleUpdate()
    {
        Eigen::Matrix3d factor;
        factor << 0.5, 0.0, 0.0, 0.4, 0.3, 0.0, -0.2, 0.1, 0.6;
        prior = factor * centredNoise(Eigen::Vector3d::Ones(), kMembers, rng);
        prior.colwise() += Eigen::Vector3d(1.0, -2.0, 0.5);
        seen << 1.0, 1.0, 0.0, 0.0, -1.0, 2.0;
        readings = {.predicted = seen * prior,
                    .measured = Eigen::Vector2d(-0.4, 3.5),
                    .sd = Eigen::Vector2d(0.3, 0.5)};
        state = prior;
    }
    static Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& members)
    {
        const Eigen::MatrixXd a = anomalies(members);
        return a * a.transpose() / static_cast<double>(members.cols() - 1);
    }
    /// Returns the gain of the Kalman filter for the prior's covariance.
    Eigen::MatrixXd gain() const
    {
        const Eigen::MatrixXd covariance = covarianceOf(prior);
        Eigen::MatrixXd ofReadings = seen * covariance * seen.transpose();
        ofReadings.diagonal() += readings.sd.cwiseAbs2();
        return covariance * seen.transpose() * ofReadings.inverse();
    }
    Eigen::Vector3d posteriorMean() const
    {
        const Eigen::Vector3d mean = prior.rowwise().mean();
        return mean + gain() * (readings.measured - seen * mean);
    }

    std::mt19937_64 rng{1};
    Eigen::MatrixXd prior, state;
    Eigen::Matrix<double, 2, 3> seen;
    EnsembleReadings readings;
    Eigen::VectorXd everywhere = Eigen::Vector3d::Ones();
};

TEST_F(EnsembleUpdate, hasTheMeanOfTheKalmanFilter)
{
    updateEnsemble(state, readings, everywhere, 0.0, rng);
    EXPECT_LT((state.rowwise().mean() - posteriorMean()).norm(), 1e-10);
}

TEST_F(EnsembleUpdate, hasTheCovarianceOfTheKalmanFilter)
{
    updateEnsemble(state, readings, everywhere, 0.0, rng);
    const Eigen::MatrixXd before = covarianceOf(prior);
    const Eigen::MatrixXd expected = before - gain() * seen * before;
    EXPECT_LT((covarianceOf(state) - expected).norm(), 0.05 * expected.norm());
}

TEST_F(EnsembleUpdate, leavesRowsBeyondTheTaperAlone)
{
    updateEnsemble(state, readings, Eigen::Vector3d(1.0, 0.0, 1.0), 0.0, rng);
    EXPECT_EQ(state.row(1), prior.row(1));
    EXPECT_NE(state.row(0), prior.row(0));
}

TEST_F(EnsembleUpdate, keepsTheSpreadWhereItIsRelaxedWholly)
{
    updateEnsemble(state, readings, everywhere, 1.0, rng);
    EXPECT_LT((state.rowwise().mean() - posteriorMean()).norm(), 1e-10);
    EXPECT_LT((anomalies(state) - anomalies(prior)).norm(), 1e-8);
}

TEST(EnsembleTaper, fallsFrom1To0)
{
    EXPECT_DOUBLE_EQ(taperAt(0.0, 0.7), 1.0);
    EXPECT_NEAR(taperAt(-0.7, 0.7), 5.0 / 24.0, 1e-12);
    EXPECT_GT(taperAt(0.7, 0.7), taperAt(1.0, 0.7));
    EXPECT_DOUBLE_EQ(taperAt(1.4, 0.7), 0.0);
}

}  // namespace
}  // namespace terratact
