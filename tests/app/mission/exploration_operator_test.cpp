// Tests the operator's commands: STOP, its release, and driving.
#include "app/display/translated.h"
#include "core/log/session_reader.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

TEST_F(Bench, stopIsSentAtOnceAndRepeatedUntilConfirmed)
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
    EXPECT_TRUE(mentions(exploration->whyNotDriving(), "STOP is latched: release it first"));
}

TEST_F(Bench, stopPressedElsewhereIsOneEventForEachPress)
{
    exploration->stop();
    tick();
    telemetry.activity = RobotActivity::Stopped;
    tick(2);
    ASSERT_EQ(exploration->stopViewState().state, StopViewState::State::Confirmed);
    QStringList decided;
    int happened = 0;
    QObject::connect(exploration.get(), &Exploration::decided, exploration.get(),
                     [&](const char* what, const Message& text) {
                         decided << QString::fromLatin1(what) + ": " + translated(text);
                     });
    QObject::connect(exploration.get(), &Exploration::happened, exploration.get(),
                     [&] { ++happened; });
    (void)sent<StopCommand>();
    for (int press = 1; press <= 3; ++press) {
        const int before = sent<StopCommand>();
        exploration->stopFrom(Message::verbatim("in another window"));
        EXPECT_EQ(sent<StopCommand>(), before + 1) << "it is sent all the same";
        tick(3);
        EXPECT_EQ(decided.size(), press);
    }
    EXPECT_EQ(decided.last(), "stop: in another window");
    EXPECT_EQ(happened, 0) << "the robot has confirmed it before";
}

TEST_F(Bench, stopIsReleasedWhenTheRobotConfirms)
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

TEST_F(Bench, drivingEndsWithOneHaltIfItHadBegun)
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

TEST_F(Bench, theSpeedOfADriveFollowsItsControl)
{
    const auto speeds = [this] {
        std::vector<double> found;
        (void)sent<DriveCommand>();
        for (const Command& command : all)
            if (const auto* drive = std::get_if<DriveCommand>(&command))
                found.push_back(drive->speed);
        return found;
    };
    exploration->setDriveSpeed(0.1);
    EXPECT_EQ(speeds(), std::vector<double>()) << "a speed alone drives nothing";
    exploration->drive(-1);
    exploration->setDriveSpeed(0.15);
    exploration->setDriveSpeed(0.15);
    EXPECT_EQ(speeds(), (std::vector{-0.1, -0.15}));
    exploration->halt();
    exploration->setDriveSpeed(0.3);
    exploration->setDriveSpeed({});
    EXPECT_EQ(speeds().size(), 2U) << "halted";
    exploration->drive(+1);
    EXPECT_EQ(speeds().back(), exploration->options().driveSpeed);
}

TEST_F(Bench, closingHaltsMotionCommandedFromHere)
{
    exploration->drive(+1);
    exploration->leave();
    EXPECT_EQ(sent<HaltCommand>(), 1);
    press();
    const int before = sent<AbortAtemCommand>();
    exploration->leave();
    EXPECT_EQ(sent<AbortAtemCommand>(), before + 1);
}

TEST_F(Bench, anyReachableBinCanReplaceTheProposal)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    const quint64 first = exploration->proposal()->id;
    ASSERT_EQ(exploration->proposal()->bin, kBin06);
    exploration->askProbe({8});
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_NE(exploration->proposal()->id, first) << "another question";
    exploration->approve(first);
    tick();
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe) << "the word was for another bin";
    exploration->askProbe({0});
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_TRUE(events.join(' ').contains("does not reach the ground at"))
        << events.join('|').toStdString();
    EXPECT_EQ(sent<ProbeCommand>(), 0) << "asking moves nothing";
    exploration->approve(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    EXPECT_EQ(exploration->probingPlace(), ProbePlace{8});
    EXPECT_EQ(sent<ProbeCommand>(), 1);
}

TEST_F(Bench, aBinChosenLaterIsProposedAfterANewPress)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_FALSE(exploration->whyNotAsking({8}));
    exploration->askProbe({8});
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
    exploration->askProbe({8});
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
    const TwoTrackEstimate shown = *exploration->estimation().estimate();
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

TEST_F(Bench, forgettingNothingKeepsTheHintOnHowToGetAnEstimate)
{
    tick(3);
    ASSERT_FALSE(exploration->estimation().estimate());
    const std::string hint = exploration->whyNoEstimate().english();
    exploration->forgetResult();
    tick(3);
    EXPECT_EQ(exploration->whyNoEstimate().english(), hint);
}

}  // namespace
}  // namespace terratact
