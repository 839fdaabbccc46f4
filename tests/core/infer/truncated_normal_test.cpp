#include "core/infer/truncated_normal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/distributions.h"

namespace terratact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();

struct Case {
    double ceiling, mean, sigma;
};

std::vector<double> sample(const Case& c, std::size_t n, unsigned seed = 20150205)
{
    std::mt19937_64 rng(seed);
    std::vector<double> h(n);
    for (double& x : h) x = drawBelow(c.ceiling, c.mean, c.sigma, rng);
    return h;
}

class DrawBelow : public testing::TestWithParam<Case> {};

TEST_P(DrawBelow, matchesTheAnalyticDistribution)
{
    const auto [ceiling, mean, sigma] = GetParam();
    const std::vector<double> h = sample(GetParam(), 20000);
    EXPECT_LE(*std::max_element(h.begin(), h.end()), ceiling);
    EXPECT_LT(kolmogorov(h, truncatedCdf(ceiling, mean, sigma)), 2.23);  // false alarm 1e-4
}

// Heights as in a scene, ceilings that many deviations from the mean, both sides of every branch.
INSTANTIATE_TEST_SUITE_P(
    Ceilings, DrawBelow,
    testing::Values(Case{kInfinity, -0.2, 0.05}, Case{0.1, -0.2, 0.05},  // ∞, +6
                    Case{-0.18, -0.2, 0.05}, Case{-0.2, -0.2, 0.05},     // +0.4, 0
                    Case{std::nextafter(-0.2, -1.0), -0.2, 0.05},        // just below 0
                    Case{-0.21, -0.2, 0.05}, Case{-0.25, -0.2, 0.05},    // −0.2, −1
                    Case{-0.3, -0.2, 0.05}, Case{-0.6, -0.2, 0.05},      // −2, −8
                    Case{-2.1, -0.2, 0.05}, Case{-38.0, 0.0, 1.0},       // −38
                    Case{-1e5, 0.0, 1.0}, Case{-0.999999e6, 0.0, 1.0},   // −1e5, below the switch
                    Case{-1.000001e6, 0.0, 1.0}, Case{0.0, 1e8, 1.0}));  // above it, −1e8

struct Moments {
    double a, excess, variance;  // of a standard normal variable above a; excess = mean − a
};

class DrawBelowMoments : public testing::TestWithParam<Moments> {};

TEST_P(DrawBelowMoments, matchTheReferenceOfEightyDigits)
{
    const auto [a, excess, variance] = GetParam();
    constexpr std::size_t n = 1000000;
    const std::vector<double> h = sample({-a, 0.0, 1.0}, n);  // mirrored: ours is cut off above
    double mean = 0.0;
    for (const double x : h) mean += (-a - x) / n;
    double spread = 0.0;
    for (const double x : h) spread += (-a - x - mean) * (-a - x - mean) / n;
    EXPECT_NEAR(mean, excess, 5.0 * std::sqrt(variance / n));
    EXPECT_NEAR(spread, variance, 5.0 * variance * std::sqrt(8.0 / n));  // kurtosis ≤ 9
}

INSTANTIATE_TEST_SUITE_P(Mpmath, DrawBelowMoments,
                         testing::Values(Moments{0, 0.79788456080286536, 0.36338022763241866},
                                         Moments{1, 0.5251352761609812, 0.19909766557034879},
                                         Moments{3, 0.2830986549304365, 0.070559186785268117},
                                         Moments{5, 0.1865039671258421, 0.032696434617112225},
                                         Moments{8, 0.1213681122361127, 0.01432488344334091},
                                         Moments{10, 0.098093233962512, 0.0094453778256562612},
                                         Moments{20, 0.049753068527851, 0.0024632616150521636},
                                         Moments{37, 0.02698768612699, 0.00072727809887751334},
                                         Moments{39, 0.025607419930108, 0.0006548827702932843},
                                         Moments{100, 0.00999800099926, 9.994004994826345e-5},
                                         Moments{1e5, 9.999999998e-6, 9.999999994e-11}));

class DrawBelowExtreme : public testing::TestWithParam<Case> {};

TEST_P(DrawBelowExtreme, isFiniteAndNeverAboveTheCeiling)
{
    for (const double h : sample(GetParam(), 2000)) {
        ASSERT_TRUE(std::isfinite(h));
        ASSERT_LE(h, GetParam().ceiling);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Corners, DrawBelowExtreme,
    testing::Values(Case{-1e300, 0.0, 1.0}, Case{1e300, 0.0, 1.0}, Case{-1e-300, 0.0, 1.0},
                    Case{1e-300, 0.0, 1.0}, Case{-1.0, 0.0, 1e-300}, Case{0.0, 0.0, 1e-300},
                    Case{0.3, 0.3, 5e-324}, Case{0.0, 5e-324, 5e-324}, Case{-1.0, 1.0, 5e-324},
                    Case{-kLargest, kLargest, 1.0}, Case{-kLargest, kLargest, kLargest},
                    Case{-kLargest, 0.0, kLargest}, Case{kInfinity, kLargest, kLargest},
                    Case{kInfinity, -kLargest, kLargest}, Case{kLargest, kLargest, kLargest},
                    Case{0.0, 1e154, 1.0}, Case{0.0, 1e155, 1.0}, Case{-1e8, 0.0, 1.0}));

TEST(DrawBelowFarTail, isAnExponentialOfRateAOverSigma)
{
    // a deviations away the spread below the ceiling is sigma/a: heights near 0 still carry it.
    for (const double a : {1e12, 1e160}) {
        const std::vector<double> h = sample({0.0, a, 1.0}, 20000);
        EXPECT_LT(kolmogorov(h, [a](double x) { return std::exp(a * x); }), 2.23) << a;
    }
}

TEST(DrawBelowFarTail, isRightWhereTheDistanceOverflowsButNotTheNumberOfDeviations)
{
    const std::vector<double> h = sample({-0.9e308, 0.9e308, 0.3e308}, 20000);
    EXPECT_LT(kolmogorov(h, [](double x) { return truncatedCdf(-3.0, 3.0, 1.0)(x / 0.3e308); }),
              2.23);
}

TEST(DrawBelowStream, isTheSameForTheSameSeedAndEveryStandardLibrary)
{
    EXPECT_EQ(sample({-0.3, -0.2, 0.05}, 100, 7), sample({-0.3, -0.2, 0.05}, 100, 7));
    EXPECT_NE(sample({-0.3, -0.2, 0.05}, 100, 7), sample({-0.3, -0.2, 0.05}, 100, 8));
    EXPECT_NEAR(sample({kInfinity, 0.0, 1.0}, 1, 1).front(), 0.039399956754155335, 1e-14);
    EXPECT_NEAR(sample({-2.0, 0.0, 1.0}, 1, 1).front(), -2.8329157376232192, 1e-14);
}

TEST(DrawBelowArguments, thatMeanNothingAreRefused)
{
    std::mt19937_64 rng(1);
    for (const Case& c : {Case{-kInfinity, 0, 1}, Case{kNan, 0, 1}, Case{0, kNan, 1},
                          Case{0, kInfinity, 1}, Case{0, -kInfinity, 1}, Case{0, 0, 0},
                          Case{0, 0, -1}, Case{0, 0, kNan}, Case{0, 0, kInfinity}})
        EXPECT_THROW(drawBelow(c.ceiling, c.mean, c.sigma, rng), std::invalid_argument)
            << c.ceiling << ' ' << c.mean << ' ' << c.sigma;
}

TEST(DrawBelowEffort, isAFewRandomNumbersHoweverFarTheCeiling)
{
    for (const double ceiling : {6.0, 0.0, -0.1, -2.0, -38.0, -1e5, -1e300}) {
        std::mt19937_64 rng(1);
        std::mt19937_64 counted(1);
        for (int i = 0; i < 500; ++i) drawBelow(ceiling, 0.0, 1.0, rng);
        int used = 0;
        for (; counted != rng && used < 10000; ++used) counted();
        EXPECT_LT(used, 500 * 6) << ceiling;
    }
}

}  // namespace
}  // namespace terratact
