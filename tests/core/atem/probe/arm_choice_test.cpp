#include "core/atem/probe/arm_choice.h"

#include "core/atem/probe/probe_policy.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/absolem.h"

#include <limits>

namespace terratact {
namespace {

constexpr int kBin05 = 8, kBin06 = 9, kBin07 = 10;

/// The arm reaches bins 0.4 … 0.7; every bin is sampled with 1 cm sd.
struct ArmChoice : testing::Test {
    ArmChoice()
    {
        robot.armReachBegin = 0.35;
        robot.armReachEnd = 0.75;
        robot.armSd = 0.03;
        estimate.sd.fill(0.01);
        estimate.settings.probeAbove = 0.06;
    }
    RobotModel robot;
    TerrainEstimate estimate;
};

TEST_F(ArmChoice, proposesNothingWhenEveryBinIsCertain)
{
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
}

TEST_F(ArmChoice, takesTheMostUncertainBin)
{
    estimate.sd[kBin06] = 0.07;
    estimate.sd[kBin07] = 0.09;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin07);
}

TEST_F(ArmChoice, theLimitItselfIsNotAboveTheLimit)
{
    estimate.sd[kBin06] = 0.06;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
    estimate.sd[kBin06] = std::nextafter(0.06, 1.0);
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

TEST_F(ArmChoice, leavesOutBinsOutOfReach)
{
    estimate.sd[0] = 0.5;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
    estimate.sd[kBin06] = 0.07;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

TEST_F(ArmChoice, proposesNothingWithoutAnArm)
{
    estimate.sd[kBin06] = 0.5;
    ASSERT_EQ(proposeProbe(estimate, robot), kBin06);
    robot.armSd = 0.0;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
    estimate.settings.method = Method::Joint;
    estimate.draws = {Heights{}, Heights{}, Heights{}};
    EXPECT_EQ(chooseProbe(estimate, robot), std::nullopt);
}

TEST_F(ArmChoice, leavesOutBinsThatWereMeasured)
{
    estimate.sd[kBin05] = 0.2;
    estimate.origin[kBin05] = Origin::Contact;
    estimate.sd[kBin06] = 0.2;
    estimate.origin[kBin06] = Origin::Arm;
    EXPECT_EQ(proposeProbe(estimate, robot), std::nullopt);
}

TEST_F(ArmChoice, takesTheNearerOfEquals)
{
    estimate.sd[kBin06] = estimate.sd[kBin07] = 0.08;
    EXPECT_EQ(proposeProbe(estimate, robot), kBin06);
}

TEST(ChooseProbe, takesTheBinWithTheLargestGain)
{
    // Bins 0.5 and 0.6 vary together. Bin 0.7 is slightly less certain, but a reading of it informs
    // about itself only.
    const RobotModel robot = absolem();
    TerrainEstimate estimate;
    estimate.settings.method = Method::Local;
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    for (int d = 0; d < 1000; ++d) {
        Heights h{};
        h[8] = h[9] = 0.1 * normal(rng);
        h[10] = 0.11 * normal(rng);
        estimate.draws.push_back(h);
    }
    estimate.sd[8] = estimate.sd[9] = 0.1;
    estimate.sd[10] = 0.11;
    EXPECT_EQ(proposeProbe(estimate, robot), 10);
    const auto chosen = chooseProbe(estimate, robot);
    ASSERT_TRUE(chosen);
    EXPECT_TRUE(*chosen == 8 || *chosen == 9) << *chosen;

    const ProbeAdvice advice = adviseProbe(estimate, robot, 0.1);
    EXPECT_EQ(advice.place, ProbePlace{*chosen});
    EXPECT_EQ(advice.gains.front().bin, *chosen);
    EXPECT_NEAR(advice.before.variance, 0.01 + 0.01 + 0.0121, 0.004);
    EXPECT_GT(advice.gains.front().varianceReduction, 0.5 * advice.before.variance);
    EXPECT_GT(advice.before.entropy, 0.3);
    EXPECT_TRUE(std::none_of(advice.gains.begin(), advice.gains.end(),
                             [](const ProbeGain& g) { return g.bin < 6; }));  // out of reach

    estimate.settings.method = Method::Pafc;
    EXPECT_EQ(chooseProbe(estimate, robot), 10);
    EXPECT_EQ(adviseProbe(estimate, robot, 0.1).place, ProbePlace{10});
    estimate.settings.method = Method::Local;
    estimate.sd.fill(0.01);
    EXPECT_EQ(chooseProbe(estimate, robot), std::nullopt);
    const ProbeAdvice unasked = adviseProbe(estimate, robot, 0.1);
    EXPECT_EQ(unasked.place, std::nullopt);
    EXPECT_EQ(unasked.before, advice.before) << "what it would buy is told all the same";
    EXPECT_EQ(unasked.gains, advice.gains);
}

/// An estimate whose sides are uncertain at +0.5 m: left by 0.1 m, right by rightSd.
TwoTrackEstimate unsureSides(double rightSd, bool onePlane = false)
{
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    TwoTrackEstimate both;
    for (TerrainEstimate& side : both.side) side.settings.probeAbove = 0.05;
    for (int d = 0; d < 1000; ++d)
        for (std::size_t side = 0; side < 2; ++side) {
            Heights h{};
            h[8] = (side == 0 ? 0.1 : rightSd) * normal(rng);
            both.side[side].draws.push_back(h);
        }
    both.side[0].sd[8] = 0.1;
    both.side[1].sd[8] = rightSd;
    return onePlane ? equalSides(both.side[0]) : both;
}

TEST_F(ArmChoice, namesTheLessCertainSide)
{
    EXPECT_EQ(adviseProbe(unsureSides(0.2), robot, 0.1).place, (ProbePlace{8, ProbeSide::Right}));
    EXPECT_EQ(adviseProbe(unsureSides(0.01), robot, 0.1).place, (ProbePlace{8, ProbeSide::Left}));
    EXPECT_EQ(proposeProbe(unsureSides(0.2), robot), (ProbePlace{8, ProbeSide::Right}));
    EXPECT_EQ(chooseProbe(unsureSides(0.01), robot), (ProbePlace{8, ProbeSide::Left}));
    const ProbeAdvice advice = adviseProbe(unsureSides(0.2), robot, 0.1);
    EXPECT_NEAR(advice.before.variance, 0.01 + 0.04, 0.006) << "of both sides";
}

TEST_F(ArmChoice, ofOnePlaneIsInTheMiddle)
{
    const TwoTrackEstimate plane = unsureSides(0.2, true);
    const ProbeAdvice advice = adviseProbe(plane, robot, 0.1);
    EXPECT_EQ(advice, adviseProbe(plane.side[0], robot, 0.1));
    EXPECT_EQ(advice.place, ProbePlace{8});
}

TEST_F(ArmChoice, offersNoSideBeyondTheArm)
{
    robot.armReachY = robot.lateral.flipperY - 0.01;
    const ProbeAdvice advice = adviseProbe(unsureSides(0.2), robot, 0.1);
    EXPECT_FALSE(advice.place);
    EXPECT_TRUE(advice.gains.empty());
}

/// Bin 0.6 says most about the terrain, bin 0.7 most about the step.
const ProbeAdvice kTwoAims{
    .place = ProbePlace{kBin06},
    .before = {.variance = 0.02, .entropy = 0.6},
    .gains = {{kBin06, 0.01, 0.1}, {kBin05, 0.006, 0.0}, {kBin07, 0.005, 0.4}},
    .stepLimit = 0.1};

TEST(OfferProbe, followsThePolicyAndNamesTheReason)
{
    struct Case {
        ProbePolicy policy;
        StepVerdict verdict;
        ProbeOffer offer;
    };
    using enum StepVerdict;
    using enum ProbePolicy;
    for (const auto& [policy, verdict, offer] :
         {Case{Variance, CannotTell, {ProbePlace{kBin06}, NoProbe::None}},
          Case{Variance, Blocked, {ProbePlace{kBin06}, NoProbe::None}},
          Case{VarianceOpen, CannotTell, {ProbePlace{kBin06}, NoProbe::None}},
          Case{VarianceOpen, Blocked, {{}, NoProbe::Decided}},
          Case{VarianceOpen, Clear, {{}, NoProbe::Decided}},
          Case{Question, CannotTell, {ProbePlace{kBin07}, NoProbe::None}},
          Case{Question, Clear, {{}, NoProbe::Decided}}})
        EXPECT_EQ(offerProbe(kTwoAims, verdict, policy), offer)
            << name(policy) << ", " << name(verdict);
    EXPECT_EQ(ranked(kTwoAims, VarianceOpen), kTwoAims.gains);
    EXPECT_EQ(ranked(kTwoAims, Question).front().bin, kBin07);
    EXPECT_EQ(ranked(kTwoAims, Question).back().bin, kBin05);
}

TEST(OfferProbe, questionPolicyIgnoresSdButNeedsAGain)
{
    using enum ProbePolicy;
    ProbeAdvice certain = kTwoAims;
    certain.place.reset();
    EXPECT_EQ(offerProbe(certain, StepVerdict::CannotTell, Variance),
              (ProbeOffer{{}, NoProbe::Certain}));
    EXPECT_EQ(offerProbe(certain, StepVerdict::CannotTell, Question),
              (ProbeOffer{ProbePlace{kBin07}, NoProbe::None}));
    for (ProbeGain& gain : certain.gains) gain.entropyReduction = 0.9 * kMinBits * std::log(2.0);
    EXPECT_EQ(offerProbe(certain, StepVerdict::CannotTell, Question),
              (ProbeOffer{{}, NoProbe::NoGain}));
    certain.gains.clear();  // no draws: the gain of the question is unknown
    EXPECT_EQ(offerProbe(certain, StepVerdict::CannotTell, Question),
              (ProbeOffer{{}, NoProbe::Certain}));
    certain.place = ProbePlace{kBin05};
    EXPECT_EQ(offerProbe(certain, StepVerdict::CannotTell, Question),
              (ProbeOffer{ProbePlace{kBin05}, NoProbe::None}));
}

TEST(AdviseProbe, isEmptyForARobotWithoutAnArm)
{
    TerrainEstimate estimate;
    estimate.draws = {Heights{}, Heights{}, Heights{}};
    estimate.draws[0][9] = 0.3;
    estimate.sd[9] = 0.2;
    RobotModel robot = absolem();
    robot.armSd = 0.0;
    const ProbeAdvice advice = adviseProbe(estimate, robot, 0.1);
    EXPECT_TRUE(advice.gains.empty());
    EXPECT_FALSE(advice.place);
    EXPECT_GT(advice.before.variance, 0.0);
}

TEST(AdviseProbe, leavesOutMeasuredBins)
{
    const RobotModel robot = absolem();
    TerrainEstimate estimate;
    estimate.draws = {Heights{}, Heights{}, Heights{}};
    estimate.draws[0][9] = 0.3;
    estimate.sd[9] = 0.2;
    estimate.origin[8] = Origin::Contact;
    for (const ProbeGain& gain : adviseProbe(estimate, robot, 0.1).gains) EXPECT_NE(gain.bin, 8);
    EXPECT_EQ(adviseProbe(estimate, robot, 0.1).place, ProbePlace{9});
}

}  // namespace
}  // namespace terratact
