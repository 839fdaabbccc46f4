// Tests which probe is proposed, and when a proposal is void.
#include "app/mission/probe_proposals.h"

#include "core/log/session_reader.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

TEST(BestProbe, saysWhyThereIsNone)
{
    TwoTrackEstimate estimate = equalSides(stepEstimate());
    ProbeAdvice advice;
    RobotModel robot;
    robot.armReachBegin = 0.35;
    robot.armReachEnd = 0.75;
    const ProbeBasis basis{estimate, advice, robot, 45.0, ProbePolicy::Variance};
    const auto why = [&basis] {
        return bestProbe(basis) ? std::string() : whyNoBestProbe(basis).english();
    };
    robot.armSd = 0.0;
    EXPECT_EQ(why(), "no probe: the arm measures no height");
    robot.armSd = 0.03;
    EXPECT_EQ(why(), "the gain of a probe is being computed");
    advice.stepLimit = kStepLimit;
    EXPECT_EQ(why(), "") << "there is one";
    for (TerrainEstimate& side : estimate.side) side.origin.fill(Origin::Arm);
    EXPECT_EQ(why(), "no probe: no bin in reach is left");
}

TEST_F(Bench, withoutAnEstimateNoBestProbeNeedsAReason)
{
    EXPECT_FALSE(exploration->bestProbe());
    EXPECT_TRUE(exploration->whyNoBestProbe().empty());
}

TEST_F(Bench, anAnswerToAnotherProposalIsIgnored)
{
    propose();
    const quint64 id = exploration->proposal()->id;
    exploration->approve(id + 1);
    exploration->refuse(id - 1);
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(Bench, newStepLimitVoidsTheOldProposal)
{
    propose();
    const ProbeProposal before = *exploration->proposal();
    exploration->setStepLimit(0.2);
    ASSERT_TRUE(gui::eventually([this] { return exploration->proposal()->stepLimit == 0.2; }));
    const ProbeProposal after = *exploration->proposal();
    EXPECT_EQ(after.bin, before.bin);
    exploration->approve(before.id);
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe) << "nobody was shown that";
    exploration->approve(after.id);
    EXPECT_TRUE(reaches(AtemPhase::Probing));
}

TEST_F(Bench, stepLimitChangedDuringAnEstimateIsProposed)
{
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    exploration->setStepLimit(0.2);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_TRUE(gui::eventually([this] { return exploration->proposal()->stepLimit == 0.2; }));
}

TEST_F(Bench, openPolicyProposesNoProbeForADecidedVerdict)
{
    withDraws = true;
    propose();
    EXPECT_EQ(exploration->estimation().verdict()->both, StepVerdict::Blocked);
    EXPECT_FALSE(exploration->whyNotOffered());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "The probe was refused"));
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));

    exploration->setProbePolicy(ProbePolicy::VarianceOpen);
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(exploration->proposal());
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "BLOCKED is decided"));
    EXPECT_TRUE(exploration->bestProbe()) << "it can still be read what it would buy";
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));

    exploration->setStepLimit(0.3);  // higher than the step: CLEAR
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "CLEAR is decided"));
}

TEST_F(Bench, aLimitChangedDuringAnEstimateDecidesWhatIsOffered)
{
    withDraws = true;
    stepInHalf = true;  // half of the draws have a step of about 0.15 m
    exploration->setProbePolicy(ProbePolicy::Question);
    exploration->setStepLimit(1.0);  // no step is that high, so no probe is proposed
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    exploration->setStepLimit(kStepLimit);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << exploration->whyNotOffered().value_or(Message()).english();
    EXPECT_EQ(exploration->proposal()->stepLimit, kStepLimit);
    EXPECT_GT(exploration->proposal()->bitsBefore, 0.9);
}

TEST_F(Bench, stepLimitChangedAndRestoredDelaysNothing)
{
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    const double limit = exploration->options().stepLimit;
    exploration->setStepLimit(0.5);
    ASSERT_TRUE(answerIsQueued());
    QCoreApplication::processEvents();  // requests advice again
    exploration->setStepLimit(limit);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->proposal()->stepLimit, limit);
}

TEST_F(Bench, adviceForAnOlderEstimateIsIgnored)
{
    propose();
    exploration->approve(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    telemetry.activity = RobotActivity::Probing;
    tick(3);
    blocked = true;
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    ASSERT_TRUE(reaches(AtemPhase::EstimatingAgain));
    const Estimation& estimation = exploration->estimation();
    std::optional<ProbeAdvice> offered;
    QObject::connect(&estimation, &Estimation::offered, [&] { offered = estimation.advice(); });
    exploration->setStepLimit(
        // Advice of the first estimate, which waits behind the second in the worker.
        0.2);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_TRUE(offered);
    EXPECT_EQ(offered->stepLimit, 0.2);
    EXPECT_NE(offered->place, ProbePlace{kBin06}) << "the arm has just been there";
}

}  // namespace
}  // namespace terratact
