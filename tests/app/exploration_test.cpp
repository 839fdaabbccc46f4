#include <QLabel>

#include "app/link_status.h"
#include "tests/support/exploration_bench.h"
#include "widgets/status_header.h"

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
    const int pressed = estimates;  // and the live ones while the flippers moved

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
    ASSERT_EQ(exploration->estimation().ledger().entries().size(), 1U);
    EXPECT_TRUE(exploration->estimation().ledger().entries()[0].in80);
    EXPECT_TRUE(events.join('\n').contains("inside the band"));

    exploration->drive(+1);
    EXPECT_EQ(sent<DriveCommand>(), 1);
    telemetry.activity = RobotActivity::Driving;
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->estimation().estimate()) << "it held for another place";
}

/// A bench whose robot stands on an estimate and then drives.
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
    telemetry.time += 2.0;  // of silence
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

TEST_F(Bench, aLivePreviewEndsWithTheExploration)
{
    exploration->request();
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
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
    tick();  // halting
    tick();
    EXPECT_EQ(phase(), AtemPhase::Halting) << "this line may have been measured before the halt";
    tick();
    EXPECT_EQ(phase(), AtemPhase::Pressing);
    telemetry.activity = RobotActivity::Pressed;  // from an earlier exploration
    tick();
    EXPECT_EQ(phase(), AtemPhase::Pressing);
    tickInSilence(3);
    EXPECT_EQ(phase(), AtemPhase::Pressing) << "without telemetry there is no answer at all";
}

TEST_F(Bench, whyTheRobotRefusedIsTold)
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

TEST_F(Bench, anAnswerToAnotherProposalMeansNothing)
{
    propose();
    const quint64 id = exploration->proposal()->id;
    exploration->approve(id + 1);
    exploration->refuse(id - 1);
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(Bench, anotherLimitAsksAnewAndAnAnswerToTheOldQuestionIsNone)
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

TEST_F(Bench, aLimitChangedDuringAnEstimateIsThatOfItsQuestion)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(gui::eventually([this] { return estimates > 0; }));
    exploration->setStepLimit(0.2);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_TRUE(gui::eventually([this] { return exploration->proposal()->stepLimit == 0.2; }));
}

TEST_F(Bench, aVerdictThatStandsIsAskedForNoProbeWhereThePolicyHasItSo)
{
    withDraws = true;
    propose();
    EXPECT_EQ(exploration->estimation().verdict()->outlook, Outlook::Blocked);
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

TEST_F(Bench, noAnswerMeansNo)
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
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(Bench, stopGoesOutAtOnceAndAgainUntilTheRobotConfirms)
{
    propose();
    exploration->stop();
    EXPECT_EQ(sent<StopCommand>(), 1) << "before any tick";
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
    tick(20);
    const int repeated = sent<StopCommand>();
    EXPECT_GE(repeated, 3);
    telemetry.activity = RobotActivity::Stopped;
    tick();
    (void)sent<StopCommand>();
    const int confirmed = sent<StopCommand>();
    tick(20);
    EXPECT_EQ(sent<StopCommand>(), confirmed);
    EXPECT_EQ(exploration->whyNotDriving(), "STOP is latched: release it first");
}

TEST_F(Bench, stopIsOnlySentUntilTheRobotConfirmsIt)
{
    using State = StopSight::State;
    EXPECT_EQ(exploration->stopSight().state, State::Ready);
    exploration->stop();
    EXPECT_EQ(exploration->stopSight().state, State::Sent) << "before any tick";
    tick(10);
    exploration->stop();  // pressing it again makes it no younger
    tick(10);
    EXPECT_EQ(exploration->stopSight().state, State::Sent);
    EXPECT_NEAR(exploration->stopSight().seconds, 0.8, 1e-6);
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(exploration->stopSight().state, State::Confirmed);
    tickInSilence(20);
    EXPECT_EQ(exploration->stopSight().state, State::Confirmed) << "silence takes nothing back";
    telemetry.activity = RobotActivity::Halted;
    tick();
    EXPECT_EQ(exploration->stopSight().state, State::Sent) << "but telemetry does";
    EXPECT_LT(exploration->stopSight().seconds, 0.1);
}

TEST_F(Bench, stopThatCannotLeaveIsToldOnceAndTriedAgain)
{
    using State = StopSight::State;
    source.setDeaf(true);
    exploration->stop();
    EXPECT_EQ(exploration->stopSight().state, State::NotSent);
    EXPECT_EQ(exploration->stopSight().why, "the bus is off");
    tick(20);
    EXPECT_GE(sent<StopCommand>(), 3);
    EXPECT_EQ(exploration->stopSight().state, State::NotSent);
    EXPECT_NEAR(exploration->stopSight().seconds, 0.8, 1e-6);
    EXPECT_EQ(events.filter("STOP not sent").size(), 1);
    source.setDeaf(false);
    tick(10);
    EXPECT_EQ(exploration->stopSight().state, State::Sent);
}

TEST_F(Bench, stopIsRepeatedToARobotOfWhichNothingWasEverHeard)
{
    Exploration another(source, RobotModel{}, *worker, Exploration::Options{});
    another.stop();
    for (int i = 0; i < 20; ++i) another.tick(now += 0.04, std::nullopt);
    EXPECT_GE(sent<StopCommand>(), 3);
    EXPECT_EQ(another.stopSight().state, StopSight::State::Sent);
}

TEST_F(Bench, stopIsReleasedWhenTheRobotSaysSo)
{
    exploration->stop();
    telemetry.activity = RobotActivity::Stopped;
    tick(3);
    exploration->request();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped) << "nothing but a release ends it";
    exploration->releaseStop();
    tick(10);
    EXPECT_EQ(phase(), AtemPhase::Stopped) << "the robot is still latched";
    EXPECT_GE(sent<ReleaseStopCommand>(), 2);
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    tick(10);
    EXPECT_EQ(phase(), AtemPhase::Idle);
}

TEST_F(Bench, releaseThatTheRobotDoesNotFollowIsForgotten)
{
    exploration->stop();
    telemetry.activity = RobotActivity::Stopped;
    tick(3);
    exploration->releaseStop();
    tick(130);  // 5.2 s
    const int sentSoFar = sent<ReleaseStopCommand>();
    EXPECT_TRUE(events.join('\n').contains("hold R again"));
    tick(50);
    EXPECT_EQ(sent<ReleaseStopCommand>(), sentSoFar);
    EXPECT_EQ(phase(), AtemPhase::Stopped);
}

TEST_F(Bench, stopDuringAReleaseWins)
{
    exploration->stop();
    telemetry.activity = RobotActivity::Stopped;
    tick(3);
    exploration->releaseStop();
    exploration->stop();
    telemetry.activity = RobotActivity::Halted;
    tick(30);
    EXPECT_EQ(phase(), AtemPhase::Stopped);
}

TEST_F(Bench, aRobotThatStoppedItselfIsShownAsStopped)
{
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
}

TEST_F(Bench, aLostLinkFailsTheExploration)
{
    press();
    tickInSilence(10);
    EXPECT_EQ(exploration->state().failure, AtemFailure::LinkLost);
    EXPECT_FALSE(exploration->linkAlive());
    EXPECT_FALSE(exploration->whyNotDriving().isEmpty());
    tick();
    EXPECT_TRUE(exploration->linkAlive());
}

TEST_F(Bench, theVerdictIsWithheldAsSoonAsTheTelemetryIsStale)
{
    propose();
    const auto withheld = [this] {
        const std::vector<Doubt> doubts = exploration->estimation().verdict()->doubts;
        return std::ranges::find(doubts, Doubt::Stale) != doubts.end();
    };
    const double heard = now;
    EXPECT_FALSE(withheld());
    exploration->tick(heard + kStaleAfter - 0.001, latest);
    EXPECT_FALSE(withheld());
    exploration->tick(heard + kStaleAfter + 0.001, latest);
    EXPECT_TRUE(withheld()) << "with the values";
    EXPECT_TRUE(exploration->linkAlive()) << "the link is lost later";
    now = heard + kStaleAfter + 0.001;
    tick();
    EXPECT_FALSE(withheld());
}

/// What a window shows of an exploration whose time is in the test's hands.
struct LinkBench : Bench {
    LinkBench() : display(header, banner, list, acquisition, nullptr) {}
    void showAt(double time)
    {
        exploration->tick(time, latest);
        display.show({.now = time, .newest = &*latest, .alive = exploration->linkAlive()});
    }
    StatusHeader header;
    QLabel banner;
    EventList list;
    ScriptedSource other;
    Acquisition acquisition{other};
    LinkStatus display;
};

TEST_F(LinkBench, theLinkIsLostAfterAQuarterOfASecondAndTheBannerSaysSoThen)
{
    EXPECT_EQ(exploration->options().linkLostAfter, 0.25);
    const double heard = now;
    for (const double age : {0.0, 0.15, 0.24, 0.2499}) {
        showAt(heard + age);
        EXPECT_TRUE(exploration->linkAlive()) << age;
        EXPECT_TRUE(banner.isHidden()) << age;
        EXPECT_FALSE(header.linkText().startsWith("LINK LOST")) << age;
    }
    showAt(heard + 0.2501);
    EXPECT_FALSE(exploration->linkAlive());
    EXPECT_TRUE(banner.isVisible()) << "with the first picture after that";
    EXPECT_EQ(banner.text(), "LINK LOST for 250 ms — nothing on this screen is live");
    EXPECT_TRUE(header.linkText().startsWith("LINK LOST"));
    showAt(heard + 0.26);
    EXPECT_EQ(banner.text(), "LINK LOST for 260 ms — nothing on this screen is live");
    now = heard + 0.26;
    line();
    showAt(now);
    EXPECT_TRUE(exploration->linkAlive());
    EXPECT_TRUE(banner.isHidden()) << "one line of telemetry is enough";
}

TEST_F(Bench, anAbortHaltsTheRobotAndALateResultIsNotShown)
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

TEST_F(Bench, aResultAlreadyOnItsWayWhenAbortedIsNotShown)
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

TEST_F(Bench, anEstimateDuringWhichAModelIsChosenIsMadeWithThatModel)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(gui::eventually([this] { return estimates > 0; }));
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

TEST_F(Bench, anEstimateGoesOnWhenTheModelChosenMeanwhileCannotBeLoaded)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    worker->load([]() -> Result<LoadedModel> { return Error{"no such file"}; });
    blocked = false;
    EXPECT_TRUE(reaches(AtemPhase::ProposingProbe)) << describe(exploration->state().failure);
}

TEST_F(Bench, anEstimateThatFailsIsToldInWords)
{
    broken = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::EstimateError);
    EXPECT_TRUE(events.join('\n').contains("covariance is not positive definite"));
}

TEST_F(Bench, aRobotThatRefusesToPressIsNotWaitedFor)
{
    exploration->request();
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    tick(4);  // stays halted
    EXPECT_EQ(exploration->state().failure, AtemFailure::PressRefused);
}

TEST_F(Bench, aCommandThatDoesNotGetOutIsTold)
{
    source.setDeaf(true);
    exploration->drive(+1);
    EXPECT_TRUE(events.join('\n').contains("the bus is off"));
}

TEST_F(Bench, drivingEndsWithOneHaltAndOnlyIfItBegan)
{
    exploration->halt();
    EXPECT_EQ(sent<HaltCommand>(), 0);
    exploration->drive(-1);
    exploration->halt();
    exploration->halt();
    EXPECT_EQ(sent<HaltCommand>(), 1);
    propose();
    const int before = sent<HaltCommand>();
    exploration->drive(+1);
    EXPECT_EQ(sent<DriveCommand>(), 1) << "not while exploring";
    exploration->halt();
    EXPECT_EQ(sent<HaltCommand>(), before) << "a halt would end the press";
}

TEST_F(Bench, leavingHaltsWhatWasSetInMotion)
{
    exploration->drive(+1);
    exploration->leave();
    EXPECT_EQ(sent<HaltCommand>(), 1);
    press();
    const int before = sent<AbortAtemCommand>();
    exploration->leave();
    EXPECT_EQ(sent<AbortAtemCommand>(), before + 1);
}

TEST_F(Bench, whatSpeaksAgainstAnExplorationIsListed)
{
    using Level = Precondition::Level;
    const auto level = [this](const QString& words) {
        for (const Precondition& p : exploration->preconditions())
            if (p.text.contains(words)) return static_cast<int>(p.level);
        return -1;
    };
    EXPECT_EQ(level("telemetry"), static_cast<int>(Level::Met));
    telemetry.roll = 0.2;
    tick();
    EXPECT_EQ(level("roll"), static_cast<int>(Level::Doubtful));
    exploration->overrideDoubts();
    EXPECT_EQ(level("roll"), static_cast<int>(Level::Overridden));
    EXPECT_TRUE(exploration->overridden().contains("roll"));
    EXPECT_TRUE(events.filter("overridden by the operator").size() == 1) << "it is logged";
    telemetry.roll = 0.0;
    tick();
    EXPECT_TRUE(exploration->overridden().isEmpty()) << "an override must not outlive its reason";
    exploration->overrideDoubts();
    EXPECT_TRUE(exploration->overridden().isEmpty()) << "nor come before it";
    telemetry.rearLeft = 0.4;
    tick();
    EXPECT_EQ(level("flippers differ"), static_cast<int>(Level::Doubtful));
    tickInSilence(10);
    EXPECT_EQ(level("telemetry"), static_cast<int>(Level::Missing));
}

TEST_F(Bench, whatOnlyTheRobotKnowsIsNotMetOnceItIsNotHeard)
{
    EXPECT_EQ(linesOf(exploration->preconditions()),
              "✔ telemetry is live\n✔ STOP is not latched\n✔ model fake.ttm is ready\n"
              "✔ left and right agree, roll is small");
    exploration->tick(now + 0.849, latest);
    const QString stale = "✘ no telemetry from the robot\n"
                          "! STOP: not known, no telemetry\n"
                          "✔ model fake.ttm is ready\n! left, right: not known, no telemetry";
    EXPECT_EQ(linesOf(exploration->preconditions()), stale);
    EXPECT_TRUE(linesOf(exploration->toDrive()).startsWith("! STOP: not known"));

    telemetry.roll = 0.2;
    tick();
    exploration->tick(now + 0.849, latest);
    exploration->overrideDoubts();
    EXPECT_EQ(exploration->overridden(), "")
        << "of a roll that was, nobody can take anything upon him";
    EXPECT_EQ(linesOf(exploration->preconditions()), stale);
    tick();
    EXPECT_TRUE(linesOf(exploration->preconditions()).contains("! roll +11.5°"));

    Exploration unheard(source, RobotModel{}, *worker, Exploration::Options{});
    unheard.tick(now, std::nullopt);
    EXPECT_FALSE(linesOf(unheard.preconditions()).contains("✔ STOP"));
    EXPECT_TRUE(linesOf(unheard.preconditions()).contains("! left, right: not known"));
}

TEST_F(Bench, everyCommandListsWhatItNeeds)
{
    EXPECT_EQ(linesOf(exploration->toDrive()),
              "✔ STOP is not latched\n✔ nothing is being explored\n✔ telemetry is live");
    EXPECT_EQ(linesOf(exploration->toProbe()), "✔ telemetry is live\n✘ no probe is proposed");
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✔ telemetry is live\n✘ there is no STOP to release");
    propose();
    EXPECT_TRUE(linesOf(exploration->toDrive()).contains("✘ An exploration is running"));
    EXPECT_EQ(linesOf(exploration->toProbe()),
              "✔ telemetry is live\n✔ scene, settings and model are those of the question");
    exploration->stop();
    tick();
    EXPECT_TRUE(linesOf(exploration->toDrive()).startsWith("✘ STOP is latched: release it first"));
    EXPECT_TRUE(linesOf(exploration->toReleaseStop()).contains("! the robot has not confirmed"));
    telemetry.activity = RobotActivity::Stopped;
    tick();
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✔ telemetry is live\n✔ the robot says that it is stopped");
    tickInSilence(10);
    EXPECT_EQ(linesOf(exploration->toReleaseStop()),
              "✘ no telemetry from the robot\n"
              "! the robot said that it is stopped, then no telemetry");
}

TEST_F(Bench, anOverrideIsOfOneDoubtAsLargeAsItWas)
{
    using Level = Precondition::Level;
    const auto levels = [this](Level level) {
        int count = 0;
        for (const Precondition& p : exploration->preconditions()) count += p.level == level;
        return count;
    };
    telemetry.roll = 0.105;  // 6°
    tick();
    exploration->overrideDoubts();
    EXPECT_EQ(exploration->overridden(), "roll +6.0°: left and right ground differ");
    telemetry.roll = 0.15;
    tick();
    EXPECT_EQ(levels(Level::Overridden), 1) << "as good as the same";
    EXPECT_TRUE(exploration->overridden().contains("6.0°")) << "what was overridden then";

    telemetry.rearLeft = 0.4;
    tick();
    EXPECT_EQ(levels(Level::Overridden), 1);
    EXPECT_EQ(levels(Level::Doubtful), 1) << "nobody has overridden the flippers";
    exploration->overrideDoubts();
    EXPECT_EQ(events.filter("overridden by the operator").size(), 2) << "each once";
    EXPECT_EQ(levels(Level::Overridden), 2);

    telemetry.roll = 0.52;  // 30°
    tick();
    EXPECT_EQ(levels(Level::Doubtful), 1);
    EXPECT_FALSE(exploration->overridden().contains("roll"));
    EXPECT_TRUE(exploration->overridden().contains("flippers"));
    EXPECT_EQ(events.filter("the override has ended: roll +29.8°").size(), 1);
}

TEST_F(Bench, anOverrideWhoseDoubtGoesWhileExploringEndsWithItsReason)
{
    telemetry.roll = 0.105;
    tick();
    exploration->overrideDoubts();
    exploration->request();
    tick();
    ASSERT_EQ(phase(), AtemPhase::Halting);
    telemetry.roll = 0.0;
    tick();
    EXPECT_EQ(exploration->overridden(), "");
    EXPECT_EQ(events.filter("the override has ended: the roll is small again").size(), 1);
}

TEST_F(Bench, aSceneIsTheFirstLineOfThePressHoweverLateTheWindowLooks)
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
