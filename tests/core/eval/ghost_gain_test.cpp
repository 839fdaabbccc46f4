#include "core/eval/ghost_gain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace terratact {
namespace {

/// `drives` drives of ten scenes with one bin: errors of about 0.1 m; those of `after` are smaller
/// by `gain`.
struct Pairs {
    std::vector<Scene> scenes;
    std::vector<BinError> before, after;

    Pairs(int drives, double gain, double coveredBefore, double coveredAfter)
    {
        std::mt19937_64 rng(3);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int d = 0; d < drives; ++d)
            for (int k = 0; k < 10; ++k) {
                BinError e{.scene = scenes.size(), .label = "a", .bin = 4};
                e.error = 0.1 + 0.02 * share(rng);
                e.scores.crps = 0.07;
                e.scores.in80 = k < 10 * coveredBefore;
                before.push_back(e);
                e.error = -(e.error - gain);
                e.scores.crps -= gain;
                e.scores.in80 = k < 10 * coveredAfter;
                after.push_back(e);
                scenes.emplace_back().run = "drive " + std::to_string(d);
            }
    }
    PairedGain gain() const { return pairedGain(before, after, scenes, 1, 200); }
};

TEST(PairedGain, helpsWhenErrorsShrinkAndTheBandStaysHonest)
{
    const PairedGain gain = Pairs(8, 0.01, 0.8, 0.8).gain();
    EXPECT_EQ(gain.n, 80U);
    EXPECT_EQ(gain.drives, 8U);
    ASSERT_TRUE(gain.intervals);
    EXPECT_NEAR(gain.intervals->mean.low, -0.01, 1e-9) << "each error beside its own";
    EXPECT_NEAR(gain.intervals->mean.high, -0.01, 1e-9);
    EXPECT_NEAR(gain.intervals->crps.high, -0.01, 1e-9);
    EXPECT_TRUE(gain.helps());
}

TEST(PairedGain, needsBothSmallerErrorsAndCalibration)
{
    EXPECT_FALSE(Pairs(8, 0.01, 0.8, 0.6).gain().helps()) << "overconfident";
    EXPECT_FALSE(Pairs(8, 0.01, 0.8, 1.0).gain().helps());
    EXPECT_TRUE(Pairs(8, 0.01, 0.6, 0.7).gain().helps()) << "better than it was";
    EXPECT_FALSE(Pairs(8, 0.0, 0.6, 0.8).gain().helps()) << "no smaller error";
    EXPECT_FALSE(Pairs(8, -0.01, 0.8, 0.8).gain().helps());
}

TEST(PairedGain, decidesNothingFromFewDrives)
{
    const PairedGain gain = Pairs(4, 0.01, 0.8, 0.8).gain();
    EXPECT_FALSE(gain.intervals);
    EXPECT_FALSE(gain.helps());
    EXPECT_NEAR(gain.after.mean, gain.before.mean - 0.01, 1e-12);
}

TEST(PairedGain, refusesUnpairedErrors)
{
    Pairs pairs(5, 0.01, 0.8, 0.8);
    pairs.after.back().bin = 5;
    EXPECT_THROW((void)pairs.gain(), std::invalid_argument);
    pairs.after.pop_back();
    EXPECT_THROW((void)pairs.gain(), std::invalid_argument);
    pairs.before.pop_back();
    pairs.scenes.resize(3);
    EXPECT_THROW((void)pairs.gain(), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
