#include "core/infer/verdict/bimodality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace terratact {
namespace {

constexpr int kDraws = 1000;

std::vector<double> drawn(unsigned seed, auto draw)
{
    std::mt19937_64 rng(seed);
    std::vector<double> x(kDraws);
    for (double& value : x) value = draw(rng);
    return x;
}

/// Returns a share `high` of the draws around `distance`, the others around 0.
std::vector<double> heaps(unsigned seed, double high, double distance, double sd)
{
    int k = 0;
    return drawn(seed, [&, normal = std::normal_distribution<double>(0.0, sd)](auto& rng) mutable {
        return (++k <= std::lround(high * kDraws) ? distance : 0.0) + normal(rng);
    });
}

TEST(TwoModes, areNotFoundInOneCluster)
{
    for (unsigned seed = 1; seed <= 50; ++seed) {
        EXPECT_FALSE(twoModes(drawn(seed, std::normal_distribution<double>(0.3, 0.2)))) << seed;
        EXPECT_FALSE(twoModes(drawn(seed, std::uniform_real_distribution<double>(-1.0, 1.0))));
        EXPECT_FALSE(twoModes(drawn(seed, [](auto& rng) {
            const double size = std::exponential_distribution<double>(5.0)(rng);
            return std::bernoulli_distribution(0.5)(rng) ? size : -size;
        }))) << seed;
        EXPECT_FALSE(twoModes(drawn(seed, std::exponential_distribution<double>(5.0)))) << seed;
    }
}

TEST(TwoModes, ofDistantClustersAreTheirMeansAndShares)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto modes = twoModes(heaps(seed, 0.5, 0.2, 0.02));
        ASSERT_TRUE(modes) << seed;
        EXPECT_NEAR(modes->lowMean, 0.0, 0.005);
        EXPECT_NEAR(modes->highMean, 0.2, 0.005);
        EXPECT_DOUBLE_EQ(modes->lowShare, 0.5);
        EXPECT_DOUBLE_EQ(modes->highShare, 0.5);
        EXPECT_NEAR(modes->split, 0.1, 0.04);
        // Between-class variance 0.1², within 0.02².
        EXPECT_NEAR(modes->betweenShare, 0.01 / 0.0104, 0.01);
    }
}

TEST(TwoModes, mayBeUnequalButNotTiny)
{
    const auto unequal = twoModes(heaps(1, 0.15, 0.3, 0.02));
    ASSERT_TRUE(unequal);
    EXPECT_DOUBLE_EQ(unequal->highShare, 0.15);
    EXPECT_NEAR(unequal->highMean - unequal->lowMean, 0.3, 0.01);
    EXPECT_FALSE(twoModes(heaps(1, 0.05, 0.9, 0.02)));
}

TEST(TwoModes, nearEachOtherAreOne)
{
    EXPECT_FALSE(twoModes(heaps(1, 0.5, 0.05, 0.002)));
    EXPECT_TRUE(twoModes(heaps(1, 0.5, 0.07, 0.002)));
}

TEST(TwoModes, keepEqualDrawsTogether)
{
    const std::vector<double> x{0.0, 0.2, 0.0, 0.2, 0.2, 0.0, 0.2, 0.2};
    const auto modes = twoModes(x);
    ASSERT_TRUE(modes);
    EXPECT_DOUBLE_EQ(modes->split, 0.1);
    EXPECT_NEAR(modes->lowMean, 0.0, 1e-15);
    EXPECT_DOUBLE_EQ(modes->highMean, 0.2);
    EXPECT_DOUBLE_EQ(modes->lowShare, 0.375);
    EXPECT_DOUBLE_EQ(modes->betweenShare, 1.0);
    EXPECT_FALSE(twoModes(std::vector<double>(100, 0.3)));
    EXPECT_FALSE(twoModes(std::vector<double>{0.3}));
    EXPECT_FALSE(twoModes(std::vector<double>{}));
}

TEST(TwoModes, areTheBestOfAllSplits)
{
    // Compares with the definition, evaluated at every place.
    for (unsigned seed = 1; seed <= 30; ++seed) {
        std::vector<double> x = heaps(seed, 0.1 + 0.02 * seed, 0.3, 0.03);
        x.resize(150);
        x.insert(x.end(), 60, -0.2);
        std::sort(x.begin(), x.end());
        const auto squares = [](auto begin, auto end) {
            const auto n = static_cast<double>(end - begin);
            const double mean = std::accumulate(begin, end, 0.0) / n;
            return std::accumulate(begin, end, 0.0, [mean](double s, double value) {
                return s + (value - mean) * (value - mean);
            });
        };
        const double total = squares(x.begin(), x.end());
        double least = total;
        for (auto at = x.begin() + 1; at != x.end(); ++at)
            least = std::min(least, squares(x.begin(), at) + squares(at, x.end()));
        const auto modes = twoModes(x);
        if (modes)
            EXPECT_NEAR(modes->betweenShare, 1.0 - least / total, 1e-12) << seed;
        else
            EXPECT_LE(1.0 - least / total, kMinBetweenShare) << seed;
    }
}

TEST(TwoModes, moveWithTheDraws)
{
    std::vector<double> x = heaps(4, 0.4, 0.25, 0.03);
    const auto before = twoModes(x);
    for (double& value : x) value += 100.0;
    std::reverse(x.begin(), x.end());
    const auto after = twoModes(x);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->split, before->split + 100.0, 1e-9);
    EXPECT_NEAR(after->lowMean, before->lowMean + 100.0, 1e-9);
    EXPECT_NEAR(after->betweenShare, before->betweenShare, 1e-9);
}

TEST(TwoModes, areFoundPerBin)
{
    const std::vector<double> high = heaps(2, 0.3, 0.2, 0.02);
    TerrainEstimate e;
    for (const double x : high) {
        Heights h{};
        h[7] = x;
        e.draws.push_back(h);
    }
    const auto modes = twoModes(e);
    for (std::size_t i = 0; i < kBins; ++i) EXPECT_EQ(modes[i].has_value(), i == 7) << i;
    EXPECT_EQ(modes[7], twoModes(high));
    EXPECT_FALSE(twoModes(TerrainEstimate{})[0]);
    e.draws.front()[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(twoModes(e)[7]) << "of what is not finite nothing is said";
    const std::vector<double> endless{0.1, std::numeric_limits<double>::infinity()};
    EXPECT_THROW(twoModes(endless), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
