// Tests when a probe is proposed, with which limit and policy, and that the estimate is recorded before.
#include "app/mission/session_event_logger.h"
#include "app/recording/session_folder.h"
#include "core/log/session_reader.h"
#include "tests/support/exploration_bench.h"
#include "tests/support/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST_F(Bench, reasonForNoProbeUsesTheCurrentStepLimit)
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
    ASSERT_EQ(exploration->estimation().verdict()->stepVerdict, StepVerdict::CannotTell);
    EXPECT_TRUE(exploration->whyNotOffered().contains("explore again"))
        << exploration->whyNotOffered().toStdString();
    exploration->setProbePolicy(ProbePolicy::Variance);
    EXPECT_TRUE(exploration->whyNotOffered().contains("explore again"));
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_EQ(exploration->whyNotOffered(), "") << "there is no estimate";
}

TEST_F(Bench, aSuspectedPitchWithholdsTheProbe)
{
    suspicions = {{.sensor = Sensor::Pitch, .trouble = SensorTrouble::Stuck}};
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(exploration->proposal());
    EXPECT_FALSE(exploration->bestProbe()) << "no button may offer it either";
    EXPECT_TRUE(exploration->whyNotOffered().contains("the pitch may be wrong"));
    exploration->askProbe(kBin06);
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

TEST_F(Bench, aLimitChangedDuringAnEstimateDecidesWhatIsOffered)
{
    withDraws = true;
    stepInHalf = true;  // half of the draws have a step of about 0.15 m
    exploration->setProbePolicy(ProbePolicy::Question);
    exploration->setStepLimit(1.0);  // no step is that high, so no probe is proposed
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    exploration->setStepLimit(kStepLimit);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe)) << exploration->whyNotOffered().toStdString();
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

TEST_F(Bench, estimateKeepsItsProbeAdviceAfterStop)
{
    withDraws = true;
    draws = 50'000;  // enough draws that the advice polls for cancellation
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    workerHeld = true;
    ASSERT_TRUE(answerIsQueued());
    QCoreApplication::processEvents();
    ASSERT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->bestProbe()) << "not told yet";
    exploration->stop();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
    workerHeld = false;
    EXPECT_TRUE(gui::eventually([this] { return exploration->bestProbe().has_value(); }));
    EXPECT_FALSE(exploration->proposal());
}

/// An estimate whose advice for another limit is under way; the worker is held before its answer.
struct WaitingForAdvice : Bench {
    void wait()
    {
        ASSERT_NO_FATAL_FAILURE(beginToEstimate());
        exploration->setStepLimit(0.2);
        workerHeld = true;
        ASSERT_TRUE(answerIsQueued());
        QCoreApplication::processEvents();
        ASSERT_TRUE(exploration->estimation().estimate());
        ASSERT_EQ(phase(), AtemPhase::Estimating);
    }
};

TEST_F(WaitingForAdvice, doesNotWaitForTheSecondMethod)
{
    exploration->setSecondMethod(Method::Joint);
    secondBlocked = true;
    ASSERT_NO_FATAL_FAILURE(wait());
    exploration->setStepLimit(0.3);
    workerHeld = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe)) << describe(exploration->state().failure);
    EXPECT_EQ(exploration->proposal()->stepLimit, 0.3);
    EXPECT_FALSE(exploration->estimation().second());
    secondBlocked = false;
    EXPECT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().second().has_value();
    }));
}

TEST_F(WaitingForAdvice, recordsTheEstimateThatStopEnds)
{
    const TemporaryDirectory directory;
    const std::string folder = directory.file("sessions");
    {
        const auto recorder = std::make_shared<SessionRecorder>(
            SessionRecorder::Options{.folder = folder, .start = someStart()});
        const SessionEventLogger eventLogger(recorder, *exploration, *worker);
        emit worker->modelLoaded("fake.ttm", {}, {}, {});  // no recorder was connected earlier
        ASSERT_NO_FATAL_FAILURE(wait());
        exploration->stop();
        tick();
        workerHeld = false;
        ASSERT_EQ(phase(), AtemPhase::Stopped);
        ASSERT_TRUE(exploration->estimation().estimate()) << "it is on the screen";
        ASSERT_TRUE(settles());
    }
    const auto files = sessionsIn(folder);
    ASSERT_EQ(files.size(), 1U);
    auto reader = SessionReader::open(files.front());
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_EQ(reader->estimates().size(), 1U);
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
    EXPECT_NE(offered->bin, kBin06) << "the arm has just been there";
}

TEST_F(Bench, anyReachableBinCanReplaceTheProposal)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    const quint64 first = exploration->proposal()->id;
    ASSERT_EQ(exploration->proposal()->bin, kBin06);
    exploration->askProbe(8);
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_NE(exploration->proposal()->id, first) << "another question";
    exploration->approve(first);
    tick();
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe) << "the word was for another bin";
    exploration->askProbe(0);
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_TRUE(events.join(' ').contains("does not reach bin")) << events.join('|').toStdString();
    EXPECT_EQ(sent<ProbeCommand>(), 0) << "asking moves nothing";
    exploration->approve(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    EXPECT_EQ(exploration->probingBin(), 8);
    EXPECT_EQ(sent<ProbeCommand>(), 1);
}

TEST_F(Bench, aBinChosenLaterIsProposedAfterANewPress)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_EQ(exploration->whyNotAsking(8), "");
    exploration->askProbe(8);
    tick();
    EXPECT_EQ(phase(), AtemPhase::Halting);
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_EQ(sent<ProbeCommand>(), 0) << "it waits for the operator's word";
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    exploration->request();
    tick();
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->proposal()->bin, kBin06) << "asked for once, it is asked once";
}

TEST_F(Bench, aRequestedBinIsDroppedOnAbort)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    exploration->askProbe(8);
    tick();
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    ASSERT_NO_FATAL_FAILURE(propose());
    EXPECT_EQ(exploration->proposal()->bin, kBin06);
}

TEST_F(Bench, aForgottenEstimateIsBroughtBackUntilTheRobotLeaves)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    const TerrainEstimate shown = *exploration->estimation().estimate();
    exploration->forgetResult();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->estimation().estimate());
    exploration->restoreResult();
    tick(3);
    ASSERT_TRUE(exploration->estimation().estimate());
    EXPECT_EQ(*exploration->estimation().estimate(), shown);
    exploration->forgetResult();
    tick(3);
    telemetry.pitch += 0.2;
    tick(3);
    exploration->restoreResult();
    tick();
    EXPECT_FALSE(exploration->estimation().estimate()) << "of another pose";
}

TEST_F(Bench, lastMinutesUseTheOperatorsStepLimit)
{
    withDraws = true;
    exploration->setStepLimit(0.24);
    ASSERT_NO_FATAL_FAILURE(propose());
    const auto told = events.filter(QStringLiteral("a step ahead of more than"));
    ASSERT_FALSE(told.isEmpty());
    for (const QString& event : told)
        EXPECT_TRUE(event.contains(QStringLiteral("more than 240 mm"))) << event.toStdString();
}

/// A source with the name of the simulated robot.
struct BuiltInSource final : MeasurementSource {
    std::string name() const override { return "SIMULATED ROBOT"; }
    Result<std::optional<Sample>> next(std::chrono::milliseconds /*patience*/) override
    {
        return std::optional<Sample>{};
    }
    Status send(const Command& /*command*/) override { return Done{}; }
};

TEST_F(Bench, theEndOfTheGroundIsReportedWithItsFile)
{
    BuiltInSource builtIn;
    const auto toldOn = [&](const std::string& file) {
        Exploration::Options options;
        options.groundFile = file;
        Exploration drives(builtIn, RobotModel{}, *worker, options);
        QStringList told;
        QObject::connect(&drives, &Exploration::happened,
                         [&](const QString& text) { told << text; });
        telemetry.travelled = 1.0;
        telemetry.activity = RobotActivity::Driving;
        for (int i = 0; i < 40; ++i) {
            line();
            drives.tick({.now = now, .latest = latest});
        }
        return told.filter(QStringLiteral("ends here")).join('\n').toStdString();
    };
    EXPECT_EQ(toldOn({}),
              "the built-in ground ends here: drive back, or start with another --terrain");
    EXPECT_EQ(toldOn("/some/where/ditch\x1b[2J.csv"),
              "the ground of the file ditch?[2J.csv ends here: drive back, or start with another "
              "--terrain");
}

TEST_F(Bench, driveWithoutTrackMotionKeepsTheEstimate)
{
    telemetry.travelled = 1.0;
    telemetry.turned = 0.0;
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    telemetry.activity = RobotActivity::Driving;
    telemetry.frontLeft += 0.3;  // the flippers rise first
    tick(10);
    EXPECT_TRUE(exploration->estimation().estimate());
    *telemetry.travelled += 0.1;
    tick(3);
    EXPECT_FALSE(exploration->estimation().estimate());
}

}  // namespace
}  // namespace terratact
