#include "core/infer/sampling/truncated_normal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/support/distributions.h"
#include "tests/support/infinity.h"

namespace terratact {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kMin = std::numeric_limits<double>::denorm_min();

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

// Heights as in a scene. The comments give the ceiling's distance from the mean in deviations; both
// sides of every branch occur.
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

struct Row {
    double a, b;              // a standard normal variable between them
    double excess, variance;  // excess = mean − a
};

/// Expects mean and variance of 1e6 draws within 5 standard errors of the reference of 80 digits.
void expectMoments(const Row& row, std::vector<double> excess)
{
    const auto n = static_cast<double>(excess.size());
    double mean = 0.0;
    for (const double x : excess) mean += x / n;
    double spread = 0.0, fourth = 0.0;
    for (const double x : excess) {
        const double square = (x - mean) * (x - mean);
        spread += square / n;
        fourth += square * square / n;
    }
    EXPECT_LT(std::abs(mean - row.excess), 5.0 * std::sqrt(row.variance / n));
    EXPECT_LT(std::abs(spread - row.variance), 5.0 * std::sqrt((fourth - spread * spread) / n));
}

class DrawBetweenMoments : public testing::TestWithParam<Row> {};

TEST_P(DrawBetweenMoments, matchTheReferenceOfEightyDigits)
{
    const Row& row = GetParam();
    std::mt19937_64 rng(20150205);
    std::vector<double> excess(1000000);
    for (double& x : excess) x = drawBetween(row.a, row.b, 0.0, 1.0, rng) - row.a;
    expectMoments(row, excess);
}

TEST_P(DrawBetweenMoments, matchTheReferenceInTheMirrorToo)
{
    const Row& row = GetParam();
    std::mt19937_64 rng(20210601);
    std::vector<double> excess(1000000);
    for (double& x : excess) x = -row.a - drawBetween(-row.b, -row.a, 0.0, 1.0, rng);
    expectMoments(row, excess);
}

INSTANTIATE_TEST_SUITE_P(
    Mpmath, DrawBetweenMoments,
    testing::Values(Row{0, kInfinity, 0.79788456080286536, 0.36338022763241866},
                    Row{1, kInfinity, 0.5251352761609812, 0.19909766557034879},
                    Row{3, kInfinity, 0.2830986549304365, 0.070559186785268117},
                    Row{5, kInfinity, 0.1865039671258421, 0.032696434617112225},
                    Row{8, kInfinity, 0.1213681122361127, 0.01432488344334091},
                    Row{10, kInfinity, 0.098093233962512, 0.0094453778256562612},
                    Row{20, kInfinity, 0.049753068527851, 0.0024632616150521636},
                    Row{37, kInfinity, 0.02698768612699, 0.00072727809887751334},
                    Row{39, kInfinity, 0.025607419930108, 0.0006548827702932843},
                    Row{100, kInfinity, 0.00999800099926, 9.994004994826345e-5},
                    Row{1e5, kInfinity, 9.999999998e-6, 9.999999994e-11},
                    Row{10, 11, 0.098068374933019, 0.0094207719023364951},
                    Row{-1, 3, 1.28278611072715401, 0.6161417353578293},
                    Row{-2, -1, 0.6168309533684472, 0.072742886100601289},
                    Row{8, 8.3, 0.0943516704006742, 0.0056881250439280846}));

struct Interval {
    double floor, ceiling, mean, sigma;
};

std::vector<double> sampleBetween(const Interval& i, std::size_t n, unsigned seed = 20150205)
{
    std::mt19937_64 rng(seed);
    std::vector<double> h(n);
    for (double& x : h) x = drawBetween(i.floor, i.ceiling, i.mean, i.sigma, rng);
    return h;
}

class DrawBetween : public testing::TestWithParam<Interval> {};

TEST_P(DrawBetween, matchesTheAnalyticDistribution)
{
    const auto [floor, ceiling, mean, sigma] = GetParam();
    const std::vector<double> h = sampleBetween(GetParam(), 20000);
    EXPECT_LE(*std::max_element(h.begin(), h.end()), ceiling);
    EXPECT_GE(*std::min_element(h.begin(), h.end()), floor);
    EXPECT_LT(kolmogorov(h, truncatedCdf(floor, ceiling, mean, sigma)), 2.23);
}

TEST_P(DrawBetween, mirroredGivesTheNegativeOfTheSameDraws)
{
    const auto [floor, ceiling, mean, sigma] = GetParam();
    const std::vector<double> h = sampleBetween(GetParam(), 2000);
    std::vector<double> mirrored = sampleBetween(Interval{-ceiling, -floor, -mean, sigma}, 2000);
    for (double& x : mirrored) x = -x;
    EXPECT_EQ(h, mirrored);
}

TEST(DrawBetween, mirrorWithEquidistantBoundsUsesTheSameSide)
{
    for (const double half : {0.375, 2.0, kInfinity})
        for (const double mean : {0.0, 0.25}) {
            const std::vector<double> h =
                sampleBetween({mean - half, mean + half, mean, 1.0}, 2000);
            std::vector<double> mirrored =
                sampleBetween({-mean - half, -mean + half, -mean, 1.0}, 2000);
            // not the negative: it is the same deviation
            for (std::size_t k = 0; k < h.size(); ++k)
                ASSERT_NEAR(h[k] - mean, mirrored[k] + mean, 1e-15);
            for (double& x : mirrored) x = -x;
            EXPECT_LT(kolmogorov(mirrored, truncatedCdf(mean - half, mean + half, mean, 1.0)),
                      2.23);
        }
}

double above(double x)
{
    return std::nextafter(x, kInfinity);
}
double below(double x)
{
    return std::nextafter(x, -kInfinity);
}

// Every regime, and one unit in the last place on either side of each border: mean on a bound,
// width of 2.5 deviations, far tail from 1e6 deviations.
INSTANTIATE_TEST_SUITE_P(
    Regimes, DrawBetween,
    testing::Values(
        Interval{-0.5, 6.0, 0.0, 1.0}, Interval{-3.0, 0.5, 0.0, 1.0},     // wide around the mean
        Interval{-0.3, 0.4, 0.0, 1.0}, Interval{-0.2, -0.1, -0.16, 7.0},  // narrow around it
        Interval{0.5, 9.0, 0.0, 1.0}, Interval{2.0, 2.7, 0.0, 1.0},       // beside it
        Interval{30.0, 30.001, 0.0, 1.0}, Interval{1e5, 1e5 + 1e-5, 0.0, 1.0},
        Interval{0.0, 3e-8, -1e7, 1.0}, Interval{0.0, 1.0, -1e7, 1.0},  // far beside it
        Interval{-9.0, 0.0, above(0.0), 1.0}, Interval{-9.0, 0.0, 0.0, 1.0},
        Interval{-9.0, 0.0, below(0.0), 1.0}, Interval{-1.0, 0.0, above(0.0), 1.0},
        Interval{-1.0, 0.0, 0.0, 1.0}, Interval{-1.0, 0.0, below(0.0), 1.0},
        Interval{-2.0, 0.5 + 0x1p-51, 0.0, 1.0}, Interval{-2.0, 0.5, 0.0, 1.0},
        Interval{-2.0, 0.5 - 0x1p-51, 0.0, 1.0}, Interval{1.0, above(3.5), 0.0, 1.0},
        Interval{1.0, 3.5, 0.0, 1.0}, Interval{1.0, below(3.5), 0.0, 1.0},
        Interval{-1e-6, 0.0, above(1e6), 1.0}, Interval{-1e-6, 0.0, 1e6, 1.0},
        Interval{-1e-6, 0.0, below(1e6), 1.0}, Interval{-kInfinity, 0.0, above(1e6), 1.0},
        Interval{-kInfinity, 0.0, 1e6, 1.0}, Interval{-kInfinity, 0.0, below(1e6), 1.0},
        Interval{0.0, kInfinity, -2.0, 1.0},
        // These decide which bound is nearer, and so the reflection.
        Interval{-1.0, above(1.0), 0.0, 1.0}, Interval{-1.0, below(1.0), 0.0, 1.0},
        Interval{-3.0, above(3.0), 0.0, 1.0}, Interval{-3.0, below(3.0), 0.0, 1.0},
        // The interval ends where the proposal has its best rate, a = 2: 2 / (a + √(a² + 4)).
        Interval{2.0, above(2.0 + 2.0 / (2.0 + std::sqrt(8.0))), 0.0, 1.0},
        Interval{2.0, 2.0 + 2.0 / (2.0 + std::sqrt(8.0)), 0.0, 1.0},
        Interval{2.0, below(2.0 + 2.0 / (2.0 + std::sqrt(8.0))), 0.0, 1.0}));

TEST(DrawBetween, isEitherBoundForAWidthOfOneUlp)
{
    for (const double mean : {1.0, 0.0, -5.0, -1e7, 3.0}) {
        int above1 = 0;
        for (const double h : sampleBetween({1.0, above(1.0), mean, 1.0}, 2000)) {
            ASSERT_TRUE(h == 1.0 || h == above(1.0)) << mean;
            above1 += h > 1.0;
        }
        EXPECT_NEAR(above1, 1000, 110) << mean;  // 5 standard deviations
        for (const double h : sampleBetween({1.0, 1.0, mean, 1.0}, 10)) ASSERT_EQ(h, 1.0);
    }
}

TEST(DrawBetween, isUniformIfTheDensityHardlyFalls)
{
    // The log density falls by 1e-300, by some of the least doubles, and by 0 after rounding.
    std::vector<double> h = sampleBetween({0.0, 1e-300, -1.0, 1.0}, 20000);
    EXPECT_LT(kolmogorov(h, [](double x) { return x / 1e-300; }), 2.23);
    for (const double width : {kMin, 2.0 * kMin, 5.0 * kMin}) {
        h = sampleBetween({0.0, width, -1.0, 1.0}, 2000);
        EXPECT_LE(*std::max_element(h.begin(), h.end()), width);
        EXPECT_GE(*std::min_element(h.begin(), h.end()), 0.0);
    }
}

TEST(DrawBetween, isTheNearerBoundIfTheFallOverflows)
{
    constexpr double sigma = 1e-300;
    for (const double mean : {1.7e8, 0.9e8, 1e10})  // 1.7e308, 0.9e308, ∞ deviations
        for (const double width : {1.0, 2.0})
            for (const double h : sampleBetween({-width * sigma, 0.0, mean, sigma}, 200))
                ASSERT_EQ(h, 0.0) << mean << ", width " << width;
}

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

TEST(DrawBetween, isFiniteAndInBoundsForExtremeDoubles)
{
    const std::vector<double> corners{-kLargest, -1e300, -1e154, -1.0,  -1e-300, -kMin,   0.0,
                                      kMin,      1e-300, 1.0,    1e154, 1e300,   kLargest};
    std::mt19937_64 rng(1);
    for (const double a : corners)
        for (const double b : corners)
            for (const double mean : corners)
                for (const double sigma : {kMin, 1e-300, 1e-8, 1.0, 1e300, kLargest})
                    for (int k = 0; k < 3; ++k) {
                        const double floor = k == 2 ? -kInfinity : std::min(a, b);
                        const double h = drawBetween(floor, std::max(a, b), mean, sigma, rng);
                        ASSERT_TRUE(std::isfinite(h) && h >= floor && h <= std::max(a, b))
                            << floor << ' ' << std::max(a, b) << ' ' << mean << ' ' << sigma;
                    }
}

TEST(DrawBelowFarTail, isAnExponentialOfRateAOverSigma)
{
    // At a deviations the spread below the ceiling is sigma/a: heights near 0 still represent it.
    for (const double a : {1e12, 1e160}) {
        const std::vector<double> h = sample({0.0, a, 1.0}, 20000);
        EXPECT_LT(kolmogorov(h, [a](double x) { return std::exp(a * x); }), 2.23) << a;
    }
}

TEST(DrawBelowFarTail, isRightIfOnlyTheDistanceOverflows)
{
    const std::vector<double> h = sample({-0.9e308, 0.9e308, 0.3e308}, 20000);
    EXPECT_LT(kolmogorov(h, [](double x) { return truncatedCdf(-3.0, 3.0, 1.0)(x / 0.3e308); }),
              2.23);
}

TEST(DrawBelowStream, repeatsForASeedOnEveryStandardLibrary)
{
    EXPECT_EQ(sample({-0.3, -0.2, 0.05}, 100, 7), sample({-0.3, -0.2, 0.05}, 100, 7));
    EXPECT_NE(sample({-0.3, -0.2, 0.05}, 100, 7), sample({-0.3, -0.2, 0.05}, 100, 8));
    EXPECT_NEAR(sample({kInfinity, 0.0, 1.0}, 1, 1).front(), 0.039399956754155335, 1e-14);
    EXPECT_NEAR(sample({-2.0, 0.0, 1.0}, 1, 1).front(), -2.8329157376232192, 1e-14);
}

TEST(DrawBelowArguments, outOfRangeAreRefused)
{
    std::mt19937_64 rng(1);
    for (const Case& c : {Case{-kInfinity, 0, 1}, Case{kNan, 0, 1}, Case{0, kNan, 1},
                          Case{0, kInfinity, 1}, Case{0, -kInfinity, 1}, Case{0, 0, 0},
                          Case{0, 0, -1}, Case{0, 0, kNan}, Case{0, 0, kInfinity}})
        EXPECT_THROW(drawBelow(c.ceiling, c.mean, c.sigma, rng), std::invalid_argument)
            << c.ceiling << ' ' << c.mean << ' ' << c.sigma;
}

TEST(DrawBetweenArguments, outOfRangeAreRefused)
{
    std::mt19937_64 rng(1);
    for (const Interval& i :
         {Interval{1, 0, 0, 1}, Interval{kNan, 0, 0, 1}, Interval{0, kNan, 0, 1},
          Interval{kInfinity, kInfinity, 0, 1}, Interval{-kInfinity, -kInfinity, 0, 1},
          Interval{0, 1, kNan, 1}, Interval{0, 1, kInfinity, 1}, Interval{0, 1, 0, 0},
          Interval{0, 1, 0, kNan}, Interval{0, 1, 0, kInfinity}})
        EXPECT_THROW(drawBetween(i.floor, i.ceiling, i.mean, i.sigma, rng), std::invalid_argument)
            << i.floor << ' ' << i.ceiling << ' ' << i.mean << ' ' << i.sigma;
}

/// Returns how many numbers of the generator one draw takes, at most 1000.
int numbersUsed(const Interval& i, std::mt19937_64& rng)
{
    std::mt19937_64 before = rng;
    drawBetween(i.floor, i.ceiling, i.mean, i.sigma, rng);
    int used = 0;
    for (; before != rng && used < 1000; ++used) before();
    return used;
}

TEST(DrawBetweenEffort, isAFewNumbersForAnyInterval)
{
    for (const double ceiling : {6.0, 1.25, 0.0, -0.1, -2.0, -38.0, -1e5, -1e300})
        for (const double width : {1e-12, 0.1, 1.0, 2.4, 2.6, 40.0, kInfinity}) {
            std::mt19937_64 rng(1);
            int all = 0, most = 0;
            for (int k = 0; k < 500; ++k) {
                const int used = numbersUsed({ceiling - width, ceiling, 0.0, 1.0}, rng);
                all += used;
                most = std::max(most, used);
            }
            EXPECT_LT(all, 500 * 6) << ceiling << ", width " << width;
            // The header's bound gives 5e-8 for one draw, 3e-5 for these 500.
            EXPECT_LT(most, 70) << ceiling << ", width " << width;
        }
}

TEST(DrawBetweenEffort, endsWithEveryGenerator)
{
    for (const double ceiling : {3.0, 0.0, -1.0, -38.0, -1e5})
        for (const double width : {1e-12, 0.1, 2.4, 2.6, 40.0, kInfinity}) {
            const Interval i{ceiling - width, ceiling, 0.0, 1.0};
            for (const std::uint64_t word : {std::uint64_t{0}, ~std::uint64_t{0}}) {
                // The generator always gives the same number, or alternates between least and largest. Such points lie
                // outside the disc, and never below the density.
                for (const bool turns : {false, true}) {
                    long numbers = 0;
                    const double h = drawBetween(i.floor, i.ceiling, i.mean, i.sigma, [&] {
                        return ++numbers % 2 == 0 && turns ? ~word : word;
                    });
                    EXPECT_TRUE(std::isfinite(h) && h >= i.floor && h <= i.ceiling)
                        << ceiling << ", width " << width;
                    EXPECT_LE(numbers, 2L * kMaxProposals * (kMaxProposals + 1));
                }
            }
        }
}

TEST(DrawBetweenEffort, isEqualForAnotherSourceOfTheSameBits)
{
    for (const double ceiling : {3.0, 0.1, -0.5, -8.0})
        for (const double width : {0.1, 2.6, kInfinity}) {
            std::mt19937_64 one(5), two(5);
            for (int k = 0; k < 100; ++k)
                EXPECT_EQ(drawBetween(ceiling - width, ceiling, 0.0, 1.0, one),
                          drawBetween(ceiling - width, ceiling, 0.0, 1.0, [&] { return two(); }));
        }
}

/// Returns 0 or ±10^e with e uniform, which reaches every regime.
double anyDeviations(double least, double most, std::mt19937_64& rng)
{
    const double share = static_cast<double>(rng() >> 11U) * 0x1p-53;
    const double x = std::pow(10.0, least + (most - least) * share);
    const auto bits = rng();
    return (bits & 7U) == 0 ? 0.0 : (bits & 8U) ? x : -x;
}

/// TERRATACT_DRAWS=1000000000 runs the long form, which takes about two minutes.
TEST(DrawBetween, isInBoundsInEveryOneOfManyDraws)
{
    const char* const wanted = std::getenv("TERRATACT_DRAWS");
    const std::int64_t draws = wanted ? std::stoll(wanted) : 300000;
    constexpr int kEach = 100;
    std::mt19937_64 rng(20150205);
    std::int64_t wrong = 0;
    for (std::int64_t k = 0; k < draws; k += kEach) {
        const double ceiling = anyDeviations(-10.0, 8.0, rng);
        const bool open = (rng() & 3U) == 0;
        const double floor = open ? -kInfinity : ceiling - std::abs(anyDeviations(-12.0, 9.0, rng));
        for (int e = 0; e < kEach; ++e) {
            const double h = drawBetween(floor, ceiling, 0.0, 1.0, rng);
            wrong += !(std::isfinite(h) && h >= floor && h <= ceiling);
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << draws << " draws";
}

}  // namespace
}  // namespace terratact
