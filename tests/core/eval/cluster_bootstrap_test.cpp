#include "core/eval/cluster_bootstrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/eval/confidence.h"
#include "core/infer/estimate/quantile.h"

namespace terratact {
namespace {

TEST(DriveNumbers, followTheFirstAppearanceOfARun)
{
    std::vector<Scene> scenes(5);
    const char* const runs[] = {"b", "a", "b", "c", "a"};
    for (std::size_t k = 0; k < 5; ++k) scenes[k].run = runs[k];
    EXPECT_EQ(driveNumbers(scenes), (std::vector<std::size_t>{0, 1, 0, 2, 1}));
}

TEST(ClusteredValues, haveTheStatisticsOfTheRepeatedDrives)
{
    std::mt19937_64 rng(3);
    std::vector<std::pair<double, std::size_t>> values;
    for (int k = 0; k < 40; ++k) values.emplace_back(static_cast<double>(rng() % 1000), rng() % 4);
    const ClusteredValues clustered(values);
    for (const DriveWeights& weight :
         {DriveWeights{1, 1, 1, 1}, DriveWeights{0, 2, 1, 1}, DriveWeights{4, 0, 0, 0}}) {
        std::vector<double> repeated;
        for (const auto& [value, drive] : values)
            repeated.insert(repeated.end(), weight[drive], value);
        double mean = 0.0;
        for (const double x : repeated) mean += x / static_cast<double>(repeated.size());
        EXPECT_DOUBLE_EQ(clustered.median(weight), quantile(repeated, 0.5));
        EXPECT_NEAR(clustered.mean(weight), mean, 1e-9);
    }
    EXPECT_EQ(clustered.median({0, 0, 0, 0}), 0.0);
    EXPECT_EQ(clustered.mean({0, 0, 0, 0}), 0.0);
    EXPECT_THROW((void)clustered.mean({1, 1, 1}), std::invalid_argument);
}

TEST(BootstrapDrives, drawsAllDrivesAndRepeatsForASeed)
{
    const auto first = [](const DriveWeights& weight) {
        std::size_t total = 0;
        for (const std::size_t w : weight) total += w;
        EXPECT_EQ(total, weight.size());
        return static_cast<double>(weight[0]);
    };
    const auto a = bootstrapDrives(6, 1, 3000, first);
    EXPECT_EQ(a, bootstrapDrives(6, 1, 3000, first));
    EXPECT_NE(a, bootstrapDrives(6, 2, 3000, first));
    double mean = 0.0;
    for (const double w : a) mean += w / 3000.0;
    EXPECT_NEAR(mean, 1.0, 0.07);  // 4 sd of a mean of 3000 binomials
    EXPECT_THROW(bootstrapDrives(6, 1, 0, first), std::invalid_argument);
}

TEST(BootstrapDrives, ofTheMeanSpreadsAsItsStandardError)
{
    // 40 drives of 5 equal values: the sd of the 40 drives counts.
    std::mt19937_64 rng(9);
    std::normal_distribution<double> normal;
    std::vector<std::pair<double, std::size_t>> values;
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t d = 0; d < 40; ++d) {
        const double x = normal(rng);
        sum += x;
        squares += x * x;
        values.insert(values.end(), 5, {x, d});
    }
    const double se = std::sqrt((squares / 40.0 - sum * sum / 1600.0) / 40.0);
    const ClusteredValues clustered(values);
    const Interval i = interval95(bootstrapDrives(
        40, 1, 4000, [&](const DriveWeights& weight) { return clustered.mean(weight); }));
    EXPECT_NEAR(i.high - i.low, 2.0 * 1.96 * se, 0.1 * 3.92 * se);
    EXPECT_NEAR(0.5 * (i.low + i.high), sum / 40.0, 0.2 * se);
}

/// `runs` drives of `perRun` scenes; the errors of a drive are equal: 1, 2, … cm.
struct ClusteredWorld {
    std::vector<Scene> scenes;
    std::vector<BinError> errors;

    ClusteredWorld(std::size_t runs, std::size_t perRun)
    {
        for (std::size_t k = 0; k < runs * perRun; ++k) {
            const std::size_t run = k / perRun;
            scenes.emplace_back().run = std::to_string(run);
            for (const int bin : {3, 10}) {
                BinError e;
                e.scene = k;
                e.label = "flat";
                e.bin = bin;
                e.error = 0.01 * static_cast<double>(run + 1) * (bin == 10 ? -2.0 : 1.0);
                e.scores.crps = 0.5 * std::abs(e.error);
                e.scores.in80 = run % 2 == 0;
                errors.push_back(e);
            }
        }
    }
};

TEST(Confidence, countsDrivesNotScenes)
{
    const ClusteredWorld few(8, 1);
    const ClusteredWorld many(8, 50);
    const auto a = confidence(few.errors, few.scenes, 1);
    const auto b = confidence(many.errors, many.scenes, 1);
    ASSERT_EQ(a.size(), 1U);
    EXPECT_EQ(a[0].label, "flat");
    EXPECT_EQ(a[0].drives, 8U);
    ASSERT_TRUE(a[0].intervals && b[0].intervals);
    const Interval mean = a[0].intervals->mean;
    EXPECT_NEAR(b[0].intervals->mean.low, mean.low, 1e-12);
    EXPECT_NEAR(b[0].intervals->mean.high, mean.high, 1e-12);
    EXPECT_LT(mean.low, 0.0675);  // the mean, 1.5 · 4.5 cm
    EXPECT_GT(mean.high, 0.0675);
    EXPECT_NEAR(a[0].intervals->crps.low, 0.5 * mean.low, 1e-12);
    EXPECT_LT(a[0].intervals->coverage.low, 0.3);
    EXPECT_GT(a[0].intervals->coverage.high, 0.7);
    EXPECT_LE(a[0].intervals->nearMedian.high, 0.08);  // bin 10 is not included
}

TEST(Confidence, needsFiveDrivesAndRefusesOtherScenes)
{
    const ClusteredWorld world(4, 10);
    EXPECT_FALSE(confidence(world.errors, world.scenes, 1)[0].intervals);
    EXPECT_THROW(confidence(world.errors, {}, 1), std::invalid_argument);
    EXPECT_THROW(confidence(world.errors, world.scenes, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
