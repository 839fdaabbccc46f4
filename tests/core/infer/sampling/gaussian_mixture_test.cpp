#include "core/infer/sampling/gaussian_mixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/normal.h"
#include "tests/support/simulation_based_calibration.h"

namespace terratact {
namespace {

/// Returns two separate Gaussians in two dimensions.
GaussianMixture twoHeaps()
{
    GaussianMixture m;
    m.weight = Eigen::Vector2d(0.3, 0.7);
    m.mean.resize(2, 2);
    m.mean << -1.0, 2.0, 0.5, 0.0;
    m.covariance = (Eigen::Matrix2d() << 0.5, 0.3, 0.3, 0.4).finished();
    return m;
}

/// Returns P(y_i ≤ x).
double cdf(const GaussianMixture& m, int i, double x)
{
    const double sd = std::sqrt(m.covariance(i, i));
    double sum = 0.0;
    for (Eigen::Index k = 0; k < m.weight.size(); ++k)
        sum += m.weight[k] * normalCdf((x - m.mean(i, k)) / sd);
    return sum;
}

TEST(GaussianMixture, hasQuantilesWithSpreadBelowRounding)
{
    GaussianMixture far{Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Constant(1, 1, 1e9),
                        Eigen::MatrixXd::Constant(1, 1, 1e-4)};
    for (const double p : {0.1, 0.5, 0.9}) EXPECT_NEAR(far.quantile(0, p), 1e9, 0.1);
}

TEST(GaussianMixture, quantilesInvertTheDistribution)
{
    const GaussianMixture m = twoHeaps();
    for (const int i : {0, 1})
        for (const double p : {1e-6, 0.025, 0.1, 0.3, 0.5, 0.9, 0.999})
            EXPECT_NEAR(cdf(m, i, m.quantile(i, p)), p, 1e-8) << i << " " << p;
}

TEST(GaussianMixture, densityIsTheSlopeOfTheDistribution)
{
    GaussianMixture m = twoHeaps();
    constexpr double kError = 0.2, kStep = 1e-5;
    GaussianMixture wider = m;
    wider.covariance(0, 0) += kError * kError;
    for (const double z : {-3.0, -1.0, 0.4, 2.0}) {
        const double slope = (cdf(wider, 0, z + kStep) - cdf(wider, 0, z - kStep)) / (2.0 * kStep);
        EXPECT_NEAR(std::exp(m.logDensity(0, z, kError)), slope, 1e-6) << z;
    }
    EXPECT_LT(m.logDensity(0, 1000.0, kError), -1e5) << "where the density itself is 0";
}

TEST(GaussianMixture, ofOneComponentHasTheNormalsQuantiles)
{
    GaussianMixture m;
    m.weight = Eigen::VectorXd::Ones(1);
    m.mean = Eigen::VectorXd::Constant(1, 3.0);
    m.covariance = Eigen::MatrixXd::Constant(1, 1, 4.0);
    EXPECT_NEAR(m.quantile(0, 0.9), 3.0 + 2.0 * 1.2815515655446004, 1e-7);
}

TEST(GaussianMixture, drawsHaveItsMomentsAndItsDistribution)
{
    const GaussianMixture m = twoHeaps();
    std::mt19937_64 rng(1);
    constexpr int kDraws = 200000;
    const Eigen::MatrixXd draws = m.draw(kDraws, rng);
    const Eigen::Vector2d mean = m.mean * m.weight;
    EXPECT_NEAR(draws.row(0).mean(), mean[0], 0.01);
    EXPECT_NEAR(draws.row(1).mean(), mean[1], 0.01);
    for (const double x : {-1.0, 0.0, 1.0, 2.5}) {
        const double share = static_cast<double>((draws.row(0).array() <= x).count()) / kDraws;
        EXPECT_NEAR(share, cdf(m, 0, x), 0.004) << x;
    }
}

TEST(GaussianMixture, collapsesToItsMeanAndCovariance)
{
    const GaussianMixture m = twoHeaps();
    const GaussianMixture one = m.collapsed();
    std::mt19937_64 rng(2);
    constexpr int kDraws = 200000;
    const Eigen::MatrixXd draws = m.draw(kDraws, rng);
    const Eigen::Vector2d mean = draws.rowwise().mean();
    const Eigen::MatrixXd spread = draws.colwise() - mean;
    EXPECT_TRUE(one.mean.col(0).isApprox(mean, 0.02));
    EXPECT_TRUE(one.covariance.isApprox(spread * spread.transpose() / kDraws, 0.02));
    EXPECT_EQ(one.weight.size(), 1);
}

TEST(GaussianMixture, isSurprisedByWhatNoComponentExpects)
{
    const GaussianMixture m = twoHeaps();  // means -1 and 2 in coordinate 0, variance 0.5
    EXPECT_EQ(m.surprise(0, 2.0, 0.1), 0.0);
    EXPECT_NEAR(m.surprise(0, 4.0, std::sqrt(0.5)), 2.0, 1e-12);
    EXPECT_NEAR(m.surprise(0, -2.0, std::sqrt(0.5)), 1.0, 1e-12);
}

TEST(GaussianMixture, conditioningAgreesWithWeightedDraws)
{
    const GaussianMixture before = twoHeaps();
    constexpr double kReading = 0.4, kSd = 0.5;
    GaussianMixture after = before;
    after.condition(1, kReading, kSd);

    std::mt19937_64 rng(2);
    const Eigen::MatrixXd draws = before.draw(400000, rng);
    const Eigen::ArrayXd likelihood =
        (-0.5 * ((draws.row(1).transpose().array() - kReading) / kSd).square()).exp();
    const Eigen::ArrayXd weight = likelihood / likelihood.sum();
    for (const double x : {-1.5, -0.5, 0.5, 1.5, 2.5}) {
        const double share = (draws.row(0).transpose().array() <= x).select(weight, 0.0).sum();
        EXPECT_NEAR(cdf(after, 0, x), share, 0.005) << x;
    }
    EXPECT_NEAR(after.weight.sum(), 1.0, 1e-12);
}

TEST(GaussianMixture, conditioningFollowsAReadingFarFromEveryComponent)
{
    GaussianMixture m = twoHeaps();
    m.condition(0, 1e6, 0.01);
    EXPECT_TRUE(m.weight.allFinite() && m.mean.allFinite());
    EXPECT_NEAR(m.quantile(0, 0.5), 1e6 * 0.5 / 0.5001, 2.0);  // the gain of the reading
}

TEST(GaussianMixture, orderOfTwoReadingsDoesNotMatter)
{
    GaussianMixture a = twoHeaps();
    GaussianMixture b = twoHeaps();
    a.condition(0, 0.3, 0.2);
    a.condition(1, 0.1, 0.4);
    b.condition(1, 0.1, 0.4);
    b.condition(0, 0.3, 0.2);
    EXPECT_TRUE(a.weight.isApprox(b.weight, 1e-10));
    EXPECT_TRUE(a.mean.isApprox(b.mean, 1e-10));
    EXPECT_TRUE(a.covariance.isApprox(b.covariance, 1e-10));
}

TEST(GaussianMixture, refusesInvalidMeasurements)
{
    GaussianMixture m = twoHeaps();
    EXPECT_THROW(m.condition(0, std::nan(""), 0.1), std::invalid_argument);
    EXPECT_THROW(m.condition(0, 0.0, 0.0), std::invalid_argument);
    EXPECT_THROW((void)m.quantile(0, 0.0), std::invalid_argument);
    EXPECT_THROW((void)m.quantile(0, 1.0), std::invalid_argument);
}

/// Simulation-based calibration of conditioning and drawing. The truth comes from the mixture, with
/// a reading of its second coordinate. The truth is ranked among the draws given the reading.
/// sdShare: factor of the reading's sd as the sampler assumes it; 1 is right.
double calibrationP(double sdShare)
{
    constexpr int kSets = 300, kDraws = 19;
    constexpr double kSd = 0.4;
    std::mt19937_64 rng(11);
    std::normal_distribution<double> normal;
    RankHistograms ranks(kDraws);
    for (int set = 0; set < kSets; ++set) {
        GaussianMixture m = twoHeaps();
        const Eigen::VectorXd truth = m.draw(1, rng).col(0);
        const double reading = truth[1] + kSd * normal(rng);
        // Coordinates alone have uniform ranks even for a sampler that ignores the reading.
        const auto quantities = [reading](const Eigen::VectorXd& y) {
            return Eigen::Vector3d(y[0], y[1], std::abs(y[1] - reading));
        };
        m.condition(1, reading, sdShare * kSd);
        Eigen::MatrixXd draws(3, kDraws);
        for (int d = 0; d < kDraws; ++d) draws.col(d) = quantities(m.draw(1, rng).col(0));
        ranks.add(quantities(truth), draws);
    }
    return ranks.pValue();
}

TEST(GaussianMixture, isCalibratedAfterConditioning)
{
    EXPECT_GT(calibrationP(1.0), 1e-4);
}

TEST(GaussianMixture, theCalibrationSeesAWrongSd)
{
    EXPECT_LT(calibrationP(0.3), 1e-4);
    EXPECT_LT(calibrationP(4.0), 1e-4);
}

}  // namespace
}  // namespace terratact
