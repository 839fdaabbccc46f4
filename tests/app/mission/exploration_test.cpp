

#include "app/console/link_status.h"
#include "tests/support/exploration_bench.h"
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
    EXPECT_EQ(exploration->estimation().estimate()->settings.method, Method::Local);
    const int pressed = estimates;  // live previews while the flippers moved

    exploration->approve(exploration->proposal()->id);
    tick();
    EXPECT_EQ(phase(), AtemPhase::Probing);
    EXPECT_EQ(exploration->probingBin(), kBin06);
    EXPECT_EQ(sent<ProbeCommand>(), 1);
    telemetry.activity = RobotActivity::Probing;
    tick(20);
    EXPECT_EQ(phase(), AtemPhase::Probing);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(exploration->estimation().estimate()->origin[kBin06], Origin::Arm);
    EXPECT_EQ(exploration->estimation().estimate()->settings.method, Method::Local);
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

/// A robot that stands on an estimate and then drives on.
struct DrivingOn : Bench {
    void stand()
    {
        press();
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
        exploration->refuse(exploration->proposal()->id);
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
    }
    void driveBy(double metres)
    {
        telemetry.activity = RobotActivity::Driving;
        if (telemetry.travelled) *telemetry.travelled += metres;
        tick(2);
    }
};

TEST_F(DrivingOn, leavesAGhostThatMovesWithTheTracksAndGoes)
{
    telemetry.travelled = 7.0;
    stand();
    EXPECT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().ghost()) << "the estimate itself stands";
    driveBy(0.1);
    ASSERT_TRUE(exploration->estimation().ghost());
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().verdict()) << "it decides nothing";
    EXPECT_NEAR(exploration->estimation().ghost()->motion.forward, 0.1, 1e-9);
    EXPECT_NEAR(exploration->estimation().ghost()->bin[6]->height, stepEstimate().height[7], 1e-9);
    driveBy(0.3);
    ASSERT_TRUE(exploration->estimation().ghost());
    EXPECT_NEAR(exploration->estimation().ghost()->motion.way, 0.4, 1e-9);
    EXPECT_NEAR(exploration->estimation().ghost()->bin[4]->height, stepEstimate().height[8], 1e-9);
    EXPECT_TRUE(exploration->estimation().whyNoGhost().isEmpty());
    driveBy(0.7);
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_TRUE(exploration->estimation().whyNoGhost().contains("too far"));
    telemetry.activity = RobotActivity::Halted;
    press();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_TRUE(exploration->estimation().whyNoGhost().isEmpty())
        << "of the last estimate, not of the one before";
}

TEST_F(DrivingOn, leavesNoGhostWithoutOdometryAndSaysSo)
{
    stand();
    driveBy(0.1);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_TRUE(exploration->estimation().whyNoGhost().contains("no odometry"));
}

TEST_F(DrivingOn, leavesAGhostThatIsNotShownWhileTheLinkIsLost)
{
    telemetry.travelled = 0.0;
    stand();
    driveBy(0.1);
    tickInSilence(10);
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_EQ(exploration->estimation().whyNoGhost(), "No ghost while telemetry is missing");
    tick();
    EXPECT_TRUE(exploration->estimation().ghost());
    telemetry.time += 2.0;  // two seconds of silence
    tick();
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_TRUE(exploration->estimation().whyNoGhost().contains("may have moved"));
    tickInSilence(10);
    EXPECT_TRUE(exploration->estimation().whyNoGhost().contains("may have moved"))
        << "it is ended for that, not for the silence of now";
}

TEST_F(DrivingOn, leavesNothingOfAnEstimateThatTheOperatorHasCleared)
{
    telemetry.travelled = 0.0;
    stand();
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    driveBy(0.1);
    EXPECT_FALSE(exploration->estimation().ghost());
    EXPECT_TRUE(exploration->estimation().whyNoGhost().isEmpty());
}

TEST_F(Bench, telemetryIsEstimatedLiveWhileTheFlippersMove)
{
    exploration->request();
    telemetry.activity = RobotActivity::Halted;
    EXPECT_FALSE(exploration->estimation().live());
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates >= 5;
    }));
    ASSERT_TRUE(exploration->estimation().live());
    EXPECT_EQ(exploration->estimation().live()->settings.method, Method::Local);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->proposal()) << "a preview proposes nothing";

    blocked = true;
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    EXPECT_TRUE(exploration->estimation().live()) << "stays until there is better";
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().live());
}

TEST_F(Bench, samplersGaussianProcessesArePreparedWhenIdle)
{
    tick(3);
    EXPECT_EQ(estimates, 0) << "a formula needs none";
    Settings sampled;
    sampled.method = Method::Pafc;
    exploration->setSettings(sampled);
    const auto isMade = [this](int made) {
        return gui::eventually([&] {
            tick();
            return estimates == made && settles();
        });
    };
    ASSERT_TRUE(isMade(1));
    EXPECT_EQ(lastAsked().settings.method, Method::Pafc);
    EXPECT_TRUE(lastAsked().prepares);
    EXPECT_FALSE(exploration->estimation().estimate()) << "nobody has asked for an estimate";
    tick(5);
    EXPECT_EQ(estimates, 1) << "once is enough";
    sampled.inducing = 300;
    exploration->setSettings(sampled);
    ASSERT_TRUE(isMade(2)) << "those of other settings";
    exploration->setSecondMethod(Method::Pa);
    ASSERT_TRUE(isMade(3)) << "those of the second method";
    EXPECT_EQ(lastAsked().settings.method, Method::Pa);
    EXPECT_TRUE(lastAsked().prepares);
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Local) << "nor again while the flippers move";
}

TEST_F(Bench, samplersPrepareOnceWhileTheFlippersMove)
{
    Settings sampled;
    sampled.method = Method::Pafc;
    sampled.inducing = 300;
    exploration->setSettings(sampled);
    blocked = true;
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 1;
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Pafc);
    EXPECT_EQ(lastAsked().settings.inducing, 300);
    EXPECT_TRUE(lastAsked().prepares);
    tick(5);
    EXPECT_EQ(estimates, 1) << "no preview overtakes it";
    blocked = false;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    EXPECT_EQ(exploration->estimation().live()->settings.method, Method::Local)
        << "it shows nothing";

    const int before = estimates;
    ASSERT_TRUE(gui::eventually([&] {
        tick();
        return estimates >= before + 3;
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Local) << "once is enough";
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->estimation().estimate()->settings.method, Method::Pafc);
}

TEST_F(Bench, secondMethodIsNotPreparedWhileFlippersMove)
{
    exploration->setSecondMethod(Method::Pafc);
    blocked = true;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 1;
    }));
    EXPECT_TRUE(lastAsked().prepares);
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 2;
    })) << "no preview overtakes them";
    EXPECT_EQ(lastAsked().settings.method, Method::Local);
    blocked = false;
}

TEST_F(Bench, aLivePreviewEndsWithTheExploration)
{
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    blocked = true;
    const int before = estimates;
    ASSERT_TRUE(gui::eventually([&] {
        tick();
        return estimates > before;
    }));
    ASSERT_TRUE(answerIsQueued());
    exploration->abort();
    tick();
    EXPECT_FALSE(exploration->estimation().live());
    QCoreApplication::processEvents();
    EXPECT_FALSE(exploration->estimation().live()) << "a preview already on its way is not shown";
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
    EXPECT_EQ(exploration->stateWords(), why);
    EXPECT_TRUE(events.contains("exploration failed: " + why)) << events.join('\n').toStdString();
    telemetry.refusal = Refusal::None;
    tick(10);
    EXPECT_EQ(exploration->stateWords(), why) << "also when the robot is asked for other things";
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
    EXPECT_EQ(exploration->estimation().verdict()->stepVerdict, StepVerdict::Blocked);
    EXPECT_EQ(exploration->whyNotOffered(), "");
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));

    exploration->setProbePolicy(ProbePolicy::VarianceOpen);
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(exploration->proposal());
    EXPECT_TRUE(exploration->whyNotOffered().contains("BLOCKED stands"))
        << exploration->whyNotOffered().toStdString();
    EXPECT_TRUE(exploration->bestProbe()) << "it can still be read what it would buy";
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));

    exploration->setStepLimit(0.3);  // higher than the step: CLEAR
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(exploration->whyNotOffered().contains("CLEAR stands"));
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

TEST_F(Bench, modelChosenDuringAnEstimateIsUsedForIt)
{
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    worker->load([this]() -> Result<LoadedModel> {
        return LoadedModel{
            .estimate = [this](const EstimateRequest& r, const Watch& w) { return estimate(r, w); },
            .name = "other.ttm",
            .details = {}};
    });
    ASSERT_TRUE(gui::eventually([this] { return events.contains("model other.ttm loaded"); }));
    blocked = false;
    EXPECT_TRUE(reaches(AtemPhase::ProposingProbe)) << describe(exploration->state().failure);
}

TEST_F(Bench, estimateContinuesIfTheNewModelCannotBeLoaded)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    worker->load([]() -> Result<LoadedModel> { return Error{"no such file"}; });
    blocked = false;
    EXPECT_TRUE(reaches(AtemPhase::ProposingProbe)) << describe(exploration->state().failure);
}

TEST_F(Bench, aFailedEstimateIsReportedAsText)
{
    broken = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::EstimateError);
    EXPECT_TRUE(events.join('\n').contains("covariance is not positive definite"));
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

TEST_F(Bench, sceneIsTheFirstPressedSampleHoweverLateThePoll)
{
    exploration->request();
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
    tick(3);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.pitch = 0.011;
    line();
    telemetry.pitch = 0.012;
    line();
    tick();
    ASSERT_EQ(phase(), AtemPhase::Estimating);
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.011);
}

TEST_F(Bench, aPressFromBeforeTheCommandIsNoScene)
{
    telemetry.activity = RobotActivity::Pressed;
    telemetry.pitch = 0.011;
    tick(3);
    exploration->request();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.pitch = 0.012;
    ASSERT_TRUE(reaches(AtemPhase::Estimating)) << "it was pressed again between two lines";
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.012);
}

}  // namespace
}  // namespace terratact
