#include "core/atem/probe/probe_gain.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kArmSd = 0.03;
constexpr double kStep = 0.15;

/// The arm reaches bins 0.4 … 0.7.
RobotModel robotWithArm()
{
    RobotModel robot;
    robot.armReachBegin = 0.35;
    robot.armReachEnd = 0.75;
    return robot;
}

/// Covariance like that of a real estimate: certain at the rear, uncertain ahead, with correlated
/// neighbours.
Eigen::MatrixXd covariance()
{
    Eigen::MatrixXd C(kBins, kBins);
    for (int i = 0; i < kBins; ++i)
        for (int j = 0; j < kBins; ++j)
            C(i, j) = (0.01 + 0.01 * i) * (0.01 + 0.01 * j) * std::exp(-std::abs(i - j) / 2.0);
    return C;
}

TerrainEstimate gaussianEstimate(int draws, unsigned seed)
{
    const Eigen::MatrixXd L = covariance().llt().matrixL();
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    TerrainEstimate e;
    for (int d = 0; d < draws; ++d) {
        Eigen::VectorXd z(kBins);
        for (double& value : z) value = normal(rng);
        Heights h;
        Eigen::Map<Eigen::VectorXd>(h.data(), kBins) = L * z;
        e.draws.push_back(h);
    }
    return e;
}

/// Returns Σ_i C_ib² / (C_bb + armSd²): the reduction of the trace of a normal's covariance by a
/// reading.
double exactReduction(int bin)
{
    const Eigen::MatrixXd C = covariance();
    return C.col(bin).squaredNorm() / (C(bin, bin) + kArmSd * kArmSd);
}

TEST(ProbeGains, matchTheClosedFormOfANormal)
{
    const auto gains = probeGains(gaussianEstimate(20000, 1), robotWithArm(), kArmSd, kStep);
    ASSERT_EQ(gains.size(), 4U);
    for (const ProbeGain& gain : gains)
        EXPECT_NEAR(gain.varianceReduction, exactReduction(gain.bin),
                    0.03 * exactReduction(gain.bin))
            << gain.bin;
}

TEST(ProbeGains, areNearTheClosedFormWithTheDrawsOfOneEstimate)
{
    for (unsigned seed = 1; seed <= 10; ++seed)
        for (const ProbeGain& gain :
             probeGains(gaussianEstimate(1000, seed), robotWithArm(), kArmSd, kStep))
            EXPECT_NEAR(gain.varianceReduction, exactReduction(gain.bin),
                        0.15 * exactReduction(gain.bin))
                << seed;
}

TEST(ProbeGains, comeLargestFirstFromBinsInReach)
{
    const auto gains = probeGains(gaussianEstimate(1000, 2), robotWithArm(), kArmSd, kStep);
    EXPECT_TRUE(std::is_sorted(gains.begin(), gains.end(), [](const auto& a, const auto& b) {
        return a.varianceReduction > b.varianceReduction;
    }));
    for (const ProbeGain& gain : gains) EXPECT_GE(gain.bin, 7);
    RobotModel armless;
    armless.armReachBegin = 2.0;
    armless.armReachEnd = 3.0;
    EXPECT_TRUE(probeGains(gaussianEstimate(10, 2), armless, kArmSd, kStep).empty());
    EXPECT_FALSE(bestProbe(gaussianEstimate(10, 2), armless, kArmSd, kStep));
}

TEST(ProbeGains, areNothingForABinThatIsCertain)
{
    TerrainEstimate e = gaussianEstimate(500, 3);
    for (Heights& h : e.draws) h[8] = -0.2;
    for (const ProbeGain& gain : probeGains(e, robotWithArm(), kArmSd, kStep)) {
        if (gain.bin != 8) continue;
        EXPECT_NEAR(gain.varianceReduction, 0.0, 1e-15);
        EXPECT_NEAR(gain.entropyReduction, 0.0, 1e-12);
    }
}

TEST(ProbeGains, ofAnIndependentBinLeaveTheOthersUnchanged)
{
    // With few draws a reading leaves about 70 of 200. Their plain variance would be 1/70 too small in every bin.
    constexpr int kSeeds = 40;
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal(0.0, 0.1);
    const double exact = 1e-4 / (0.01 + kArmSd * kArmSd);
    double mean = 0.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        TerrainEstimate e;
        e.draws.resize(200);
        for (Heights& h : e.draws)
            for (double& value : h) value = normal(rng);
        for (const ProbeGain& gain : probeGains(e, robotWithArm(), kArmSd, kStep))
            mean += gain.varianceReduction / (4.0 * kSeeds);
    }
    EXPECT_NEAR(mean, exact, 0.06 * exact);
}

TEST(ProbeGains, matchTheInformationAboutAStep)
{
    // Bins ahead are all up or all down: touching any of them settles the question, with log 2 in
    // all.
    TerrainEstimate e;
    for (int d = 0; d < 1000; ++d) {
        Heights h{};
        for (std::size_t i = 8; i < kBins; ++i) h[i] = d % 2 == 0 ? 0.0 : 0.3;
        e.draws.push_back(h);
    }
    for (const ProbeGain& gain : probeGains(e, robotWithArm(), kArmSd, kStep)) {
        EXPECT_NEAR(gain.entropyReduction, gain.bin >= 8 ? std::numbers::ln2 : 0.0, 1e-4);
        EXPECT_NEAR(gain.varianceReduction, gain.bin >= 8 ? 3.0 * 0.0225 : 0.0, 1e-4);
    }
    // An arm with an error larger than the step gives little information.
    const ProbeGain blunt = probeGains(e, robotWithArm(), 0.6, kStep).front();
    EXPECT_GT(blunt.entropyReduction, 0.0);
    EXPECT_LT(blunt.entropyReduction, 0.1);
}

TEST(ProbeGains, ofEntropyStayWithinZeroAndLogTwo)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (const double limit : {0.02, 0.05, 0.1, 0.2})
            for (const ProbeGain& gain :
                 probeGains(gaussianEstimate(600, seed), robotWithArm(), kArmSd, limit)) {
                EXPECT_GT(gain.entropyReduction, -0.02);
                EXPECT_LE(gain.entropyReduction, std::numbers::ln2);
            }
}

TEST(ProbeGains, areFiniteForFewAndDistantDraws)
{
    for (const int draws : {1, 2, 7}) {
        TerrainEstimate e = gaussianEstimate(draws, 5);
        e.draws.front().fill(4.0);
        for (const ProbeGain& gain : probeGains(e, robotWithArm(), 1e-6, kStep)) {
            EXPECT_TRUE(std::isfinite(gain.varianceReduction)) << draws;
            EXPECT_TRUE(std::isfinite(gain.entropyReduction)) << draws;
        }
    }
}

/// Draws of both sides: like gaussianEstimate(), with a correlation between the sides.
TwoTrackEstimate gaussianSides(int draws, double correlation, unsigned seed)
{
    const TerrainEstimate own = gaussianEstimate(draws, seed),
                          other = gaussianEstimate(draws, seed + 1);
    TwoTrackEstimate both{.side = {own, own}};
    for (std::size_t d = 0; d < own.draws.size(); ++d)
        for (std::size_t i = 0; i < kBins; ++i)
            both.side[1].draws[d][i] =
                correlation * own.draws[d][i]
                + std::sqrt(1.0 - correlation * correlation) * other.draws[d][i];
    return both;
}

TEST(ProbeGains, ofASideCountTheOtherSideToo)
{
    constexpr double kCorrelation = 0.5;
    const auto gains =
        probeGains(gaussianSides(20000, kCorrelation, 11), robotWithArm(), kArmSd, kStep);
    ASSERT_EQ(gains.size(), 8U) << "four bins of each side";
    for (const ProbeGain& gain : gains) {
        const double exact = (1.0 + kCorrelation * kCorrelation) * exactReduction(gain.bin);
        EXPECT_NEAR(gain.varianceReduction, exact, 0.05 * exact) << gain.bin;
        EXPECT_NE(gain.side, ProbeSide::Middle);
    }
}

TEST(ProbeGains, askAboutAStepOnEitherSide)
{
    TwoTrackEstimate both;
    for (int d = 0; d < 400; ++d)
        for (std::size_t side = 0; side < 2; ++side) {
            Heights h{};
            if (side == 0 ? d % 2 == 0 : d % 4 < 2) h[9] = h[10] = 0.3;
            both.side[side].draws.push_back(h);
        }
    const auto entropy = [](double p) { return -p * std::log(p) - (1.0 - p) * std::log(1.0 - p); };
    EXPECT_NEAR(uncertainty(both, kStep).entropy, entropy(0.75), 1e-9);
    EXPECT_NEAR(uncertainty(both.side[0], kStep).entropy, entropy(0.5), 1e-9);
    EXPECT_NEAR(uncertainty(equalSides(both.side[0]), kStep).entropy, entropy(0.5), 1e-9);
    const auto gains = probeGains(both, robotWithArm(), kArmSd, kStep);
    const auto at = [&](ProbeSide side) {
        return std::ranges::find_if(gains,
                                    [side](const ProbeGain& gain) {
                                        return gain.place() == ProbePlace{9, side};
                                    })
            ->entropyReduction;
    };
    // A reading of a side that shows its step decides; one that shows none leaves the other side.
    const double left = entropy(0.75) - 0.5 * entropy(0.5);
    EXPECT_NEAR(at(ProbeSide::Left), left, 0.01);
    EXPECT_NEAR(at(ProbeSide::Right), left, 0.01);
    both.side[1].draws.pop_back();
    EXPECT_THROW((void)uncertainty(both, kStep), std::invalid_argument);
}

TEST(BestProbe, isTheLargestGainAmongSampledBins)
{
    TerrainEstimate e = gaussianEstimate(1000, 6);
    const auto gains = probeGains(e, robotWithArm(), kArmSd, kStep);
    EXPECT_EQ(bestProbe(e, robotWithArm(), kArmSd, kStep), gains[0]);
    e.origin[static_cast<std::size_t>(gains[0].bin)] = Origin::Contact;
    EXPECT_EQ(bestProbe(e, robotWithArm(), kArmSd, kStep), gains[1]);
    e.origin.fill(Origin::Arm);
    EXPECT_FALSE(bestProbe(e, robotWithArm(), kArmSd, kStep));
}

TEST(ProbeGains, refuseInvalidArguments)
{
    const TerrainEstimate e = gaussianEstimate(10, 7);
    const RobotModel robot = robotWithArm();
    const double endless = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -0.1, std::nan(""), endless})
        EXPECT_THROW(probeGains(e, robot, bad, kStep), std::invalid_argument) << bad;
    for (const double bad : {-0.1, std::nan(""), endless})
        EXPECT_THROW(probeGains(e, robot, kArmSd, bad), std::invalid_argument) << bad;
    EXPECT_THROW(probeGains(TerrainEstimate{}, robot, kArmSd, kStep), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
