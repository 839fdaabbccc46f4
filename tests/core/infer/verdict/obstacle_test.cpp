#include "core/infer/verdict/obstacle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace terratact {
namespace {

/// Level ground with a step of `height` between bins `at` and at + 1.
Heights stepAt(std::size_t at, double height)
{
    Heights h{};
    for (std::size_t i = at + 1; i < kBins; ++i) h[i] = height;
    return h;
}

TerrainEstimate estimateOf(std::vector<Heights> draws)
{
    TerrainEstimate e;
    e.draws = std::move(draws);
    e.ess.fill(static_cast<double>(e.draws.size()));
    return e;
}

TEST(StepProbability, isTheShareOfDrawsWithAStep)
{
    const std::vector<Heights> draws{stepAt(2, 0.2), stepAt(5, -0.2), stepAt(5, 0.1), Heights{}};
    const StepProbability any = stepProbability(draws, 0.15, 0, kBins - 1, 4.0);
    EXPECT_DOUBLE_EQ(any.p, 0.5);
    EXPECT_DOUBLE_EQ(any.monteCarloSd, 0.25);
    EXPECT_DOUBLE_EQ(stepProbability(draws, 0.15, 3, kBins - 1, 4.0).p, 0.25);  // pair 2, 3 is out
    EXPECT_DOUBLE_EQ(stepProbability(draws, 0.15, 5, 6, 4.0).p, 0.25);
    EXPECT_DOUBLE_EQ(stepProbability(draws, 0.05, 5, 6, 4.0).p, 0.5);
    EXPECT_DOUBLE_EQ(stepProbability(draws, 0.2, 0, kBins - 1, 4.0).p, 0.0);  // not above the limit
    EXPECT_DOUBLE_EQ(stepProbability(draws, 0.15, 0, kBins - 1, 1.0).monteCarloSd, 0.5);
}

TEST(StepProbability, countsAnEdgeWithinABinAtItsFullHeight)
{
    for (const double share : {0.1, 0.5, 0.9}) {  // of the bin, below the edge
        Heights h = stepAt(7, 0.12);
        h[7] = (1.0 - share) * 0.12;
        EXPECT_TRUE(hasStep(h, 0.11)) << share;
        EXPECT_FALSE(hasStep(h, 0.13)) << share;
    }
    Heights ramp{};
    for (std::size_t i = 0; i < kBins; ++i) ramp[i] = 0.04 * static_cast<double>(i);
    EXPECT_FALSE(hasStep(ramp, 0.1)) << "0.08 m within two bins";
    EXPECT_TRUE(hasStep(ramp, 0.07));
    EXPECT_FALSE(hasStep(ramp, 0.07, 3, 4)) << "of these two bins alone";
}

TEST(StepProbability, neverClaimsCertainty)
{
    const std::vector<Heights> level(98), steps(98, stepAt(4, 0.3));
    const double sd = std::sqrt(0.01 * 0.99 / 98.0);
    const StepProbability never = stepProbability(level, 0.1, 0, 10, 98.0);
    EXPECT_EQ(never.p, 0.0);
    EXPECT_DOUBLE_EQ(never.monteCarloSd, sd);
    const StepProbability always = stepProbability(steps, 0.1, 0, 10, 98.0);
    EXPECT_EQ(always.p, 1.0);
    EXPECT_DOUBLE_EQ(always.monteCarloSd, sd);
    EXPECT_GT(stepProbability(level, 0.1, 0, 10, 2.0).monteCarloSd, 0.3);
}

TEST(StepProbability, refusesInvalidArguments)
{
    const std::vector<Heights> draws(3);
    EXPECT_THROW(stepProbability({}, 0.1, 0, 10, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, -0.1, 0, 10, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, std::nan(""), 0, 10, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, 0.1, -1, 10, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, 0.1, 0, 11, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, 0.1, 4, 4, 1.0), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, 0.1, 0, 10, 0.5), std::invalid_argument);
    EXPECT_THROW(stepProbability(draws, 0.1, 0, 10, 3.5), std::invalid_argument);
    EXPECT_THROW(anyStep(TerrainEstimate{}, 0.1), std::invalid_argument);
}

TEST(StepProbabilities, matchTheGaussianClosedForm)
{
    // h_{i+1} − h_i ~ N(0.02, 2 · 0.05²) for independent bins on a slope of 0.02 m per bin.
    constexpr int kManyDraws = 40000;
    constexpr double kLimit = 0.1, kSd = 0.05, kRise = 0.02;
    std::mt19937_64 rng(20150205);
    std::normal_distribution<double> normal(0.0, kSd);
    std::vector<Heights> draws(kManyDraws);
    for (Heights& h : draws)
        for (std::size_t i = 0; i < kBins; ++i) h[i] = kRise * static_cast<double>(i) + normal(rng);
    const auto above = [&](double x) { return 0.5 * std::erfc(x / (kSd * std::numbers::sqrt2)); };
    const double sqrt2 = std::numbers::sqrt2;
    const double expected = above((kLimit - kRise) / sqrt2) + above((kLimit + kRise) / sqrt2);

    const auto found = stepProbabilities(estimateOf(draws), kLimit);
    for (const StepProbability& step : found) {
        EXPECT_NEAR(step.monteCarloSd, std::sqrt(expected * (1.0 - expected) / kManyDraws), 2e-5);
        EXPECT_NEAR(step.p, expected, 4.5 * step.monteCarloSd);
    }
}

TEST(AnyStep, countsOnTheLeastEffectiveSampledBin)
{
    TerrainEstimate e = estimateOf({Heights{}, stepAt(6, 0.2), Heights{}, stepAt(6, 0.2)});
    EXPECT_DOUBLE_EQ(anyStep(e, 0.1).monteCarloSd, 0.25);
    e.ess[3] = 1.0;
    EXPECT_DOUBLE_EQ(anyStep(e, 0.1).monteCarloSd, 0.5);
    e.origin[3] = Origin::Contact;
    EXPECT_DOUBLE_EQ(anyStep(e, 0.1).monteCarloSd, 0.25);
    e.ess.fill(1e6);  // antithetic chains may claim more than there are
    EXPECT_DOUBLE_EQ(effectiveDraws(e), 4.0);
    e.ess[8] = 0.0;
    EXPECT_DOUBLE_EQ(effectiveDraws(e), 1.0);
    EXPECT_DOUBLE_EQ(anyStep(e, 0.1, 7, 10).p, 0.0);
    EXPECT_DOUBLE_EQ(anyStep(e, 0.1, 6, 7).p, 0.5);
}

}  // namespace
}  // namespace terratact
