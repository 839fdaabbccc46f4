#include "core/eval/scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/support/distributions.h"

namespace terratact {
namespace {

/// ∫ (F(x) − [x ≥ truth])² dx by the midpoint rule: the definition of the CRPS.
double integratedCrps(const std::function<double(double)>& cdf, double truth, double from,
                      double to)
{
    constexpr int kSteps = 400000;
    const double step = (to - from) / kSteps;
    double sum = 0.0;
    for (int k = 0; k < kSteps; ++k) {
        const double x = from + (k + 0.5) * step;
        sum += step * std::pow(cdf(x) - (x >= truth ? 1.0 : 0.0), 2);
    }
    return sum;
}

TEST(CrpsOfDraws, isTheIntegralOfTheSquaredDistance)
{
    const std::vector<double> draws{-0.3, -0.1, -0.1, 0.05, 0.4};
    const auto cdf = [&](double x) {
        return static_cast<double>(std::upper_bound(draws.begin(), draws.end(), x) - draws.begin())
             / 5.0;
    };
    for (const double truth : {-1.0, -0.3, -0.1, 0.0, 0.2, 0.4, 0.9})
        EXPECT_NEAR(crpsOfDraws(draws, truth), integratedCrps(cdf, truth, -1.5, 1.5), 1e-5)
            << truth;
}

TEST(CrpsOfDraws, ofOneDrawIsItsError)
{
    EXPECT_DOUBLE_EQ(crpsOfDraws(std::vector{0.25}, 1.0), 0.75);
    EXPECT_DOUBLE_EQ(crpsOfDraws(std::vector{0.0, 1.0}, 0.5), 0.25);  // ½ − ½ · ½
    EXPECT_THROW((void)crpsOfDraws({}, 0.0), std::invalid_argument);
}

TEST(CrpsOfNormal, isTheIntegralOfTheSquaredDistance)
{
    const auto cdf = [](double x) {
        return 0.5 * std::erfc(-(x - 0.1) / 0.2 / std::numbers::sqrt2);
    };
    for (const double truth : {-0.9, 0.0, 0.1, 0.35, 1.2})
        EXPECT_NEAR(crpsOfNormal(0.1, 0.2, truth), integratedCrps(cdf, truth, -2.0, 2.0), 1e-5)
            << truth;
}

TEST(CrpsOfNormal, isTheErrorForSdZeroAndRefusesNegativeSd)
{
    EXPECT_DOUBLE_EQ(crpsOfNormal(0.1, 0.0, 0.4), 0.3);
    EXPECT_NEAR(crpsOfNormal(0.1, 1e-9, 0.4), 0.3, 1e-8);
    EXPECT_THROW((void)crpsOfNormal(0.0, -0.1, 0.0), std::invalid_argument);
}

/// Bin 4 has the draws given, or none; mean, sd and 80 % band as given.
TerrainEstimate estimateOf(const std::vector<double>& draws, double mean, double sd, double q10,
                           double q90)
{
    TerrainEstimate e;
    for (const double h : draws) e.draws.emplace_back()[4] = h;
    e.mean[4] = e.height[4] = mean;
    e.sd[4] = sd;
    e.q10[4] = q10;
    e.q90[4] = q90;
    return e;
}

TEST(ForecastScores, ofDrawsAreThoseOfTheirDistribution)
{
    std::vector<double> draws;  // 0.00 … 1.00 backwards: quantile p is p
    for (int k = 100; k >= 0; --k) draws.push_back(0.01 * k);
    const TerrainEstimate e = estimateOf(draws, 9.0, 9.0, 0.1, 0.9);
    const auto at = [&](double truth) { return forecastScores(e, 4, truth); };
    EXPECT_NEAR(at(0.305).pit, 31.5 / 102.0, 1e-12);
    EXPECT_NEAR(at(0.5).pit, 0.5, 1e-12);  // 50 below, 1 equal
    EXPECT_TRUE(at(0.26).in50);
    EXPECT_FALSE(at(0.24).in50);
    EXPECT_FALSE(at(0.76).in50);
    EXPECT_TRUE(at(0.11).in80);
    EXPECT_FALSE(at(0.09).in80);
    EXPECT_TRUE(at(0.03).in95);
    EXPECT_FALSE(at(0.02).in95);
    EXPECT_FALSE(at(0.98).in95);
    EXPECT_DOUBLE_EQ(at(0.5).width, 0.8);
    std::sort(draws.begin(), draws.end());
    EXPECT_DOUBLE_EQ(at(0.2).crps, crpsOfDraws(draws, 0.2));
}

TEST(ForecastScores, ofAFixedBinAreThoseOfANormal)
{
    for (const auto& draws : {std::vector<double>{}, std::vector<double>{0.2, 0.2, 0.2}}) {
        const TerrainEstimate e = estimateOf(draws, 0.2, 0.1, 0.072, 0.328);
        EXPECT_NEAR(forecastScores(e, 4, 0.3).pit, 0.8413447, 1e-6);
        EXPECT_DOUBLE_EQ(forecastScores(e, 4, 0.3).crps, crpsOfNormal(0.2, 0.1, 0.3));
        EXPECT_TRUE(forecastScores(e, 4, 0.267).in50);
        EXPECT_FALSE(forecastScores(e, 4, 0.268).in50);
        EXPECT_TRUE(forecastScores(e, 4, 0.395).in95);
        EXPECT_FALSE(forecastScores(e, 4, 0.397).in95);
    }
    const TerrainEstimate sharp = estimateOf({}, 0.2, 0.0, 0.2, 0.2);
    EXPECT_EQ(forecastScores(sharp, 4, 0.2).pit, 0.5);
    EXPECT_EQ(forecastScores(sharp, 4, 0.3).pit, 1.0);
    EXPECT_EQ(forecastScores(sharp, 4, 0.1).pit, 0.0);
    EXPECT_THROW((void)forecastScores(sharp, 11, 0.0), std::invalid_argument);
}

/// Scores of a forecaster with the right spread, whose centre is shifted by `bias` sd.
struct Campaign {
    std::vector<double> pit;
    double share50 = 0.0, share80 = 0.0, share95 = 0.0;

    explicit Campaign(double bias)
    {
        constexpr int kTruths = 1500;
        std::mt19937_64 rng(5);
        std::normal_distribution<double> normal;
        for (int k = 0; k < kTruths; ++k) {
            const double centre = normal(rng);
            std::vector<double> draws(400);
            for (double& h : draws) h = centre + 0.1 * (bias + normal(rng));
            const TerrainEstimate e = estimateOf(draws, 0.0, 0.0, centre + 0.1 * (bias - 1.2816),
                                                 centre + 0.1 * (bias + 1.2816));
            const ForecastScores s = forecastScores(e, 4, centre + 0.1 * normal(rng));
            pit.push_back(s.pit);
            share50 += s.in50 ? 1.0 / kTruths : 0.0;
            share80 += s.in80 ? 1.0 / kTruths : 0.0;
            share95 += s.in95 ? 1.0 / kTruths : 0.0;
        }
    }
    double distance() const
    {
        return kolmogorov(pit, [](double p) { return p; });
    }
};

TEST(ForecastScores, pitIsUniformOnlyForCalibratedForecasts)
{
    const Campaign calibrated(0.0);
    EXPECT_LT(calibrated.distance(), 2.23);
    EXPECT_NEAR(calibrated.share50, 0.50, 0.05);  // 4 sd of a share of 1500
    EXPECT_NEAR(calibrated.share80, 0.80, 0.04);
    EXPECT_NEAR(calibrated.share95, 0.95, 0.025);
    const Campaign biased(1.0);
    EXPECT_GT(biased.distance(), 8.0);
    EXPECT_LT(biased.share80, 0.70);
}

TEST(ForecastScores, coverCountsTheSdOfTheTruth)
{
    constexpr int kTruths = 2000;
    constexpr double kTruthSd = 0.15;
    std::mt19937_64 rng(8);
    std::normal_distribution<double> normal;
    std::array<double, 3> told{}, untold{};
    std::vector<double> pit;
    double fixed = 0.0;
    for (int k = 0; k < kTruths; ++k) {
        std::vector<double> draws(200);
        for (double& h : draws) h = 0.1 * normal(rng);
        const TerrainEstimate e = estimateOf(draws, 0.0, 0.1, -0.12816, 0.12816);
        const double truth = 0.1 * normal(rng) + kTruthSd * normal(rng);
        const auto add = [](std::array<double, 3>& share, const ForecastScores& s) {
            share[0] += s.in50 ? 1.0 / kTruths : 0.0;
            share[1] += s.in80 ? 1.0 / kTruths : 0.0;
            share[2] += s.in95 ? 1.0 / kTruths : 0.0;
        };
        const ForecastScores scores = forecastScores(e, 4, truth, kTruthSd);
        pit.push_back(scores.pit);
        add(told, scores);
        add(untold, forecastScores(e, 4, truth));
        EXPECT_EQ(scores.width, forecastScores(e, 4, truth).width);
        const TerrainEstimate without = estimateOf({}, 0.0, 0.1, -0.12816, 0.12816);
        fixed += forecastScores(without, 4, truth, kTruthSd).in80 ? 1.0 / kTruths : 0.0;
    }
    EXPECT_NEAR(told[0], 0.50, 0.045);  // 4 sd of a share of 2000
    EXPECT_NEAR(told[1], 0.80, 0.036);
    EXPECT_NEAR(told[2], 0.95, 0.02);
    EXPECT_NEAR(fixed, 0.80, 0.036);
    EXPECT_LT(untold[1], 0.60);
    EXPECT_LT(kolmogorov(pit, [](double p) { return p; }), 2.23);
    EXPECT_THROW((void)forecastScores(estimateOf({}, 0.0, 0.1, 0.0, 0.0), 4, 0.0, -0.1),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
