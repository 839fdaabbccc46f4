// Tests what each command of an exploration needs.
#include "core/log/session_reader.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

TEST_F(Bench, everyCommandListsWhatItNeeds)
{
    EXPECT_EQ(linesOf(exploration->toDrive()),
              "✔ STOP is not latched\n✔ nothing is being explored\n✔ telemetry is live");
    EXPECT_EQ(linesOf(exploration->toProbe()), "✔ telemetry is live\n✘ no open question");
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✔ telemetry is live\n✘ there is no STOP to release");
    propose();
    EXPECT_TRUE(linesOf(exploration->toDrive()).contains("✘ An exploration is running"));
    EXPECT_EQ(linesOf(exploration->toProbe()),
              "✔ telemetry is live\n✔ scene, settings and model are unchanged since the question");
    exploration->stop();
    tick();
    EXPECT_TRUE(linesOf(exploration->toDrive()).startsWith("✘ STOP is latched: release it first"));
    EXPECT_TRUE(linesOf(exploration->toReleaseStop()).contains("! the robot has not confirmed"));
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✔ telemetry is live\n✔ the robot reports stopped");
    tickInSilence(10);
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✘ no telemetry from the robot\n"
              "! the robot reported stopped, then telemetry ended");
}

TEST_F(Bench, reasonForNoProbeUsesTheCurrentStepLimit)
{
    withDraws = true;
    exploration->setProbePolicy(ProbePolicy::VarianceOpen);
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "BLOCKED is decided"));
    exploration->setStepLimit(0.3);  // higher than the step
    ASSERT_TRUE(settles());
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "CLEAR is decided"));
    tickInSilence(10);
    ASSERT_EQ(exploration->estimation().verdict()->both, StepVerdict::CannotTell);
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "explore again"));
    exploration->setProbePolicy(ProbePolicy::Variance);
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "explore again"));
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->whyNotOffered()) << "there is no estimate";
}

TEST_F(Bench, aSuspectedPitchWithholdsTheProbe)
{
    suspicions = {{.sensor = Sensor::Pitch, .trouble = SensorTrouble::Stuck}};
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(exploration->proposal());
    EXPECT_FALSE(exploration->bestProbe()) << "no button may offer it either";
    EXPECT_TRUE(mentions(exploration->whyNotOffered(), "the pitch may be wrong"));
    EXPECT_TRUE(mentions(exploration->whyNoBestProbe(), "the pitch may be wrong"));
    exploration->askProbe({kBin06});
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    EXPECT_TRUE(events.last().contains("the pitch may be wrong"));
}

TEST_F(Bench, aPitchSuspectedLaterForbidsToApprove)
{
    press();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    suspicions = {{.sensor = Sensor::FrontLeft, .trouble = SensorTrouble::Stuck}};
    tick();
    EXPECT_TRUE(exploration->toProbe().last().level == Precondition::Level::Met)
        << "another sensor does not place the bins";
    suspicions = {{.sensor = Sensor::Pitch, .trouble = SensorTrouble::Late}};
    tick();
    EXPECT_EQ(exploration->toProbe().last().level, Precondition::Level::Missing);
    exploration->approve(exploration->proposal()->id);
    tick();
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

}  // namespace
}  // namespace terratact
