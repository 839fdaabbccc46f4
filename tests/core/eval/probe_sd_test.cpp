#include "core/eval/probe_sd.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace terratact {
namespace {

/// Returns readings of `places` places, `each` of every place, with noise of sd and a bias.
std::vector<ProbeReading> recording(int places, int each, double sd, double bias, bool truth,
                                    unsigned seed)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> noise(bias, sd);
    std::vector<ProbeReading> readings;
    for (int p = 0; p < places; ++p)
        for (int k = 0; k < each; ++k) {
            const double height = 0.1 * p - 0.4;
            readings.push_back({std::to_string(p), height + noise(rng),
                                truth ? std::optional(height) : std::nullopt});
        }
    return readings;
}

TEST(ProbeAccuracy, usesTheMeanOfEachPlace)
{
    const ProbeAccuracy a = probeAccuracy(recording(50, 20, 0.03, 0.2, false, 1));
    EXPECT_EQ(a.repeated.freedom, 50U * 19U);
    EXPECT_NEAR(a.repeated.sd, 0.03, 0.002);
    EXPECT_EQ(a.fromTruth.n, 0U);
    EXPECT_EQ(readingSd(a), a.repeated.sd);
}

TEST(ProbeAccuracy, intervalsHoldTheTruthIn95Percent)
{
    int held = 0;
    constexpr unsigned kSets = 400;
    for (unsigned seed = 0; seed < kSets; ++seed) {
        const SdEstimate s = probeAccuracy(recording(3, 3, 0.03, 0.0, false, seed)).repeated;
        held += s.low <= 0.03 && 0.03 <= s.high ? 1 : 0;
    }
    EXPECT_NEAR(held / static_cast<double>(kSets), 0.95, 0.04);
}

TEST(ProbeAccuracy, givesTheBiasWhereTheTruthIsKnown)
{
    const ProbeAccuracy a = probeAccuracy(recording(200, 1, 0.02, -0.015, true, 2));
    EXPECT_EQ(a.repeated, SdEstimate{});
    EXPECT_NEAR(a.fromTruth.mean, 0.015, 0.005);
    EXPECT_NEAR(readingSd(a), 0.02, 0.003);
}

TEST(ProbeAccuracy, isZeroWithoutRepetitionsOrTruth)
{
    EXPECT_EQ(readingSd(probeAccuracy(recording(5, 1, 0.02, 0.0, false, 3))), 0.0);
    EXPECT_EQ(readingSd(probeAccuracy({})), 0.0);
}

}  // namespace
}  // namespace terratact
