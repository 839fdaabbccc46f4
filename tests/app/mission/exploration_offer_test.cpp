// Tests when a probe is proposed, with which limit and policy, and that the estimate is recorded before.
#include <regex>
#include <string>

#include "app/display/translated.h"
#include "app/mission/screen_text.h"
#include "app/mission/session_event_logger.h"
#include "app/recording/session_folder.h"
#include "core/log/rows/message_json.h"
#include "core/log/session_reader.h"
#include "tests/support/benches/exploration_bench.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

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
    EXPECT_TRUE(mentions(exploration->whyNoBestProbe(), "being computed"));
    exploration->stop();
    tick();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
    releaseWorker();
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
    releaseWorker();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(exploration->state().failure).english;
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
        const auto recorder = std::make_shared<SessionRecorder>(SessionRecorder::Options{
            .folder = folder, .start = someStart(), .patience = kBusyDisk});
        const SessionEventLogger eventLogger(recorder, *exploration, *worker);
        emit worker->modelLoaded("fake.ttm", {}, {}, {}, false,
                                 {});  // no recorder was connected earlier
        ASSERT_NO_FATAL_FAILURE(wait());
        exploration->stop();
        tick();
        releaseWorker();
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

TEST_F(Bench, aDecisionRecordsWhatWasOnTheScreen)
{
    withDraws = true;
    EXPECT_EQ(screenText(*exploration, {}).english(),
              "exploration: ready; no telemetry yet; no estimate");
    ASSERT_NO_FATAL_FAILURE(propose());
    const Message screen = screenText(*exploration, {});
    EXPECT_TRUE(screen.english().starts_with("exploration: arm probe proposed; no telemetry yet; "))
        << screen.english();
    EXPECT_NE(screen.english().find("P(step > "), std::string::npos) << screen.english();
    EXPECT_NE(screen.english().find("probe proposed at "), std::string::npos) << screen.english();
    EXPECT_TRUE(messageFromJson(jsonOf(screen))) << "a session can hold it in parts";
}

TEST_F(Bench, aRecordedClearSaysHowFar)
{
    withDraws = clear = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    const std::string screen = screenText(*exploration, {}).english();
    EXPECT_TRUE(std::regex_search(
        screen,
        std::regex("CLEAR to \\+0\\.\\d\\d m; P\\(step > 0\\.\\d\\d m to \\+0\\.\\d\\d m\\) = ")))
        << screen;
}

TEST_F(Bench, lastMinutesUseTheOperatorsStepLimit)
{
    withDraws = true;
    exploration->setStepLimit(0.24);
    ASSERT_NO_FATAL_FAILURE(propose());
    const auto told = events.filter(QStringLiteral("a step of more than"));
    ASSERT_FALSE(told.isEmpty());
    for (const QString& event : told)
        EXPECT_TRUE(event.contains(QStringLiteral("more than 0.24 m"))) << event.toStdString();
}

TEST_F(Bench, theEndOfTheGroundIsReportedWithItsFile)
{
    const auto toldOn = [&](const std::string& file) {
        Exploration::Options options;
        options.groundFile = file;
        Exploration drives(source, RobotModel{}, *worker, options);
        QStringList told;
        QObject::connect(&drives, &Exploration::happened,
                         [&](const Message& text) { told << translated(text); });
        telemetry.travelled = 1.0;
        telemetry.activity = RobotActivity::Driving;
        for (int i = 0; i < 40; ++i) {
            line();
            drives.tick({.now = now, .latest = latest});
        }
        return told.filter(QStringLiteral("ends here")).join('\n').toStdString();
    };
    EXPECT_EQ(
        toldOn({}),
        "the robot drives no further: the built-in ground ends here, or is too steep. Drive back, "
        "or start with another --terrain");
    EXPECT_EQ(
        toldOn("/some/where/ditch\x1b[2J.csv"),
        "the robot drives no further: the ground of the file ditch?[2J.csv ends here, or is too "
        "steep. Drive back, or start with another "
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
