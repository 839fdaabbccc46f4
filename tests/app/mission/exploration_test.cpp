

#include "app/console/connection/link_status.h"
#include "app/display/translated.h"
#include "tests/support/benches/exploration_bench.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

TEST_F(Bench, theWholeLoop)
{
    telemetry.activity = RobotActivity::Driving;
    exploration->request();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Halting);
    EXPECT_EQ(sent<BeginAtemCommand>(), 1);
    tick(5);
    EXPECT_EQ(phase(), AtemPhase::Halting) << "still rolling";
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    EXPECT_EQ(sent<PressCommand>(), 1);
    telemetry.activity = RobotActivity::Pressing;
    tick(5);
    EXPECT_EQ(phase(), AtemPhase::Pressing);
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    ASSERT_TRUE(exploration->proposal());
    EXPECT_EQ(exploration->proposal()->bin, kBin06);
    EXPECT_EQ(exploration->estimation().estimate()->side[0].settings.method, Method::Local);
    const int pressed = estimates;  // live previews while the flippers moved

    exploration->approve(exploration->proposal()->id);
    tick();
    EXPECT_EQ(phase(), AtemPhase::Probing);
    EXPECT_EQ(exploration->probingPlace(), ProbePlace{kBin06});
    EXPECT_EQ(sent<ProbeCommand>(), 1);
    telemetry.activity = RobotActivity::Probing;
    tick(20);
    EXPECT_EQ(phase(), AtemPhase::Probing);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(exploration->estimation().estimate()->side[0].origin[kBin06], Origin::Arm);
    EXPECT_EQ(exploration->estimation().estimate()->side[0].settings.method, Method::Local);
    EXPECT_EQ(estimates, pressed + 1);
    EXPECT_EQ(exploration->estimation().counts().estimates, 2U) << "previews do not count";
    EXPECT_EQ(exploration->estimation().counts().contradicting, 0U);
    ASSERT_EQ(exploration->estimation().ledger().entries().size(), 1U);
    EXPECT_TRUE(exploration->estimation().ledger().entries()[0].in80);
    EXPECT_TRUE(events.join('\n').contains("inside the band"));

    exploration->drive(+1);
    EXPECT_EQ(sent<DriveCommand>(), 1);
    telemetry.activity = RobotActivity::Driving;
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->estimation().estimate()) << "it held for another place";
}

TEST_F(Bench, telemetryFromBeforeACommandIsNoAnswer)
{
    telemetry.activity = RobotActivity::Halted;
    exploration->request();
    tick();  // enters Halting
    tick();
    EXPECT_EQ(phase(), AtemPhase::Halting) << "this line may have been measured before the halt";
    telemetry.activity = RobotActivity::Pressed;  // state of an earlier exploration
    tick();
    EXPECT_EQ(phase(), AtemPhase::Pressing);
    tick();
    EXPECT_EQ(phase(), AtemPhase::Pressing) << "it was pressed before it was told to press";
    tickInSilence(3);
    EXPECT_EQ(phase(), AtemPhase::Pressing) << "without telemetry there is no answer at all";
    tick();
    EXPECT_EQ(phase(), AtemPhase::Estimating) << "a robot that stays pressed is";
}

TEST_F(Bench, aPressThatBeganSinceTheCommandIsItsAnswer)
{
    telemetry.activity = RobotActivity::Halted;
    exploration->request();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressed;
    tick();
    EXPECT_EQ(phase(), AtemPhase::Estimating) << "a line later would be 50 ms later";
}

TEST_F(Bench, reasonOfTheRobotsRefusalIsShown)
{
    propose();
    exploration->approve(exploration->proposal()->id);
    tick();
    telemetry.refusal = Refusal::OutOfReach;
    tick(3);
    ASSERT_EQ(exploration->state().failure, AtemFailure::ProbeRefused);
    const QString why = "the robot refused the probe: the arm does not reach that bin";
    EXPECT_EQ(translated(exploration->stateText()), why);
    EXPECT_TRUE(events.contains("exploration failed: " + why)) << events.join('\n').toStdString();
    telemetry.refusal = Refusal::None;
    tick(10);
    EXPECT_EQ(translated(exploration->stateText()), why)
        << "also when the robot is asked for other things";
}

TEST_F(Bench, aPressIsExpectedToTakeAsLongAsTheOneBefore)
{
    using Kind = PhaseTime::Kind;
    exploration->request();
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
    tick(50);
    ASSERT_TRUE(exploration->time());
    EXPECT_EQ(exploration->time()->kind, Kind::GivesUp) << "nobody knows yet";
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->time()->kind, Kind::Answer);
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    telemetry.activity = RobotActivity::Halted;
    exploration->request();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    ASSERT_TRUE(exploration->time());
    EXPECT_EQ(exploration->time()->kind, Kind::Expected);
    EXPECT_NEAR(exploration->time()->seconds, 2.0, 0.1);
}

TEST_F(Bench, aRobotThatWasNeverAskedHasNotRefused)
{
    telemetry.activity = RobotActivity::Halted;
    source.setDeaf(true);
    exploration->request();
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::NotSent);
    EXPECT_EQ(exploration->stateText().english(), "a command could not be sent: the bus is off");
}

TEST_F(Bench, anOldRefusalIsNotTheAnswerToANewCommand)
{
    telemetry.refusal = Refusal::Busy;
    exploration->request();
    tick();
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    tick();
    EXPECT_EQ(phase(), AtemPhase::Pressing);
    tick();
    EXPECT_EQ(exploration->state().failure, AtemFailure::PressRefused) << "now it is";
}

TEST_F(Bench, aRefusedProbeLeavesTheEstimate)
{
    propose();
    exploration->refuse(exploration->proposal()->id);
    tick();
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    EXPECT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->proposal());
    tick(5);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(Bench, anUnansweredProposalExpires)
{
    propose();
    const quint64 id = exploration->proposal()->id;
    tick(static_cast<int>(AtemLimits{}.approval / 0.04) + 2);
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    exploration->approve(id);
    tick(3);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
    EXPECT_TRUE(events.join('\n').contains("no answer in time"));
}

TEST_F(Bench, aMovedRobotEndsTheExplorationButOneOutlierDoesNot)
{
    propose();
    telemetry.pitch += 0.1;
    tick();
    telemetry.pitch -= 0.1;
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe);
    telemetry.frontLeft += 0.3;
    tick(2);
    EXPECT_EQ(exploration->state().failure, AtemFailure::PoseChanged);
    tick();
    EXPECT_TRUE(exploration->estimation().estimate()) << "the ground below lies where it lay";
    telemetry.pitch += 0.1;
    tick(3);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(Bench, abortHaltsTheRobotAndDropsALateResult)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    const int before = sent<AbortAtemCommand>();
    exploration->abort();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Idle);
    EXPECT_EQ(sent<AbortAtemCommand>(), before + 1);
    blocked = false;
    ASSERT_TRUE(settles());
    tick(3);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->proposal());
}

TEST_F(Bench, aResultQueuedBeforeAnAbortIsNotShown)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(answerIsQueued());
    exploration->abort();
    tick();
    QCoreApplication::processEvents();
    tick();
    EXPECT_FALSE(exploration->estimation().estimate());
}

TEST_F(Bench, aProposalMadeInTheTickOfStopIsWithdrawn)
{
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    blocked = false;
    ASSERT_TRUE(gui::eventually([this] { return exploration->proposal().has_value(); }))
        << "offered, and not looked at yet";
    exploration->stop();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
    EXPECT_FALSE(exploration->proposal());
}

TEST_F(Bench, aRefusedPressFailsWithoutWaiting)
{
    exploration->request();
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    tick(4);  // stays halted
    EXPECT_EQ(exploration->state().failure, AtemFailure::PressRefused);
}

TEST_F(Bench, aCommandThatIsNotSentIsReported)
{
    source.setDeaf(true);
    exploration->drive(+1);
    EXPECT_TRUE(events.join('\n').contains("the bus is off"));
}

}  // namespace
}  // namespace terratact
