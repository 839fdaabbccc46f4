// When a probe is offered, and for which limit and policy.
#include "tests/support/exploration_bench.h"

namespace terratact {
namespace {

TEST_F(Bench, whyNoProbeWasOfferedIsOfTheLimitOfNow)
{
    withDraws = true;
    exploration->setProbePolicy(ProbePolicy::VarianceOpen);
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(exploration->whyNotOffered().contains("BLOCKED stands"))
        << exploration->whyNotOffered().toStdString();
    exploration->setStepLimit(0.3);  // higher than the step
    ASSERT_TRUE(settles());
    EXPECT_TRUE(exploration->whyNotOffered().contains("CLEAR stands"))
        << exploration->whyNotOffered().toStdString();
    tickInSilence(10);
    ASSERT_EQ(exploration->estimation().verdict()->outlook, Outlook::CannotTell);
    EXPECT_TRUE(exploration->whyNotOffered().contains("explore again to be asked"))
        << exploration->whyNotOffered().toStdString();
    exploration->setProbePolicy(ProbePolicy::Variance);
    EXPECT_TRUE(exploration->whyNotOffered().contains("explore again to be asked"));
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_EQ(exploration->whyNotOffered(), "") << "there is no estimate";
}

TEST_F(Bench, aLimitChangedDuringAnEstimateDecidesWhatIsOffered)
{
    withDraws = true;
    stepInHalf = true;  // of the draws: a step of some 0.15 m
    exploration->setProbePolicy(ProbePolicy::Question);
    exploration->setStepLimit(1.0);  // certainly none so high: nothing to ask
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(gui::eventually([this] { return estimates > 0; }));
    exploration->setStepLimit(kStepLimit);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe)) << exploration->whyNotOffered().toStdString();
    EXPECT_EQ(exploration->proposal()->stepLimit, kStepLimit);
    EXPECT_GT(exploration->proposal()->bitsBefore, 0.9);
}

TEST_F(Bench, aLimitChangedThereAndBackDuringAnEstimateHoldsNothingUp)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(gui::eventually([this] { return estimates > 0; }));
    const double limit = exploration->options().stepLimit;
    exploration->setStepLimit(0.5);
    ASSERT_TRUE(answerIsQueued());
    QCoreApplication::processEvents();  // it is asked for advice anew
    exploration->setStepLimit(limit);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->proposal()->stepLimit, limit);
}

}  // namespace
}  // namespace terratact
