#include "drivers/memory_bus.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

/// The bus of a receive-only console.
struct SilentBus {
    MemoryBus bus{steadyNow};
    CanSource link{bus.join("can0"), RobotModel{}, {.mode = CanSource::Mode::Listen}};
};

/// An exploration that only follows the telemetry.
struct PassiveExplorationBench : SilentBus, Bench {
    PassiveExplorationBench() : Bench(&link) {}

    void robotPresses()
    {
        telemetry.activity = RobotActivity::Pressing;
        tick(3);
        telemetry.activity = RobotActivity::Pressed;
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
    }
    bool probes(const ArmReading& reading)
    {
        telemetry.activity = RobotActivity::Probing;
        if (!reaches(AtemPhase::Probing)) return false;
        telemetry.activity = RobotActivity::Pressed;
        telemetry.arm = reading;
        return reaches(AtemPhase::EstimatingAgain) && reaches(AtemPhase::Presenting);
    }
};

TEST_F(PassiveExplorationBench, estimatesAPressOnceAndSendsNothing)
{
    EXPECT_TRUE(mentions(exploration->whyNoEstimate(), "when the robot presses"));
    telemetry.activity = RobotActivity::Pressing;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    })) << "a preview while the flippers move";
    telemetry.activity = RobotActivity::Pressed;
    telemetry.pitch = 0.011;
    line();
    telemetry.pitch = 0.012;
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.011) << "its first line";
    EXPECT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().live());
    EXPECT_FALSE(exploration->proposal()) << "nobody here may approve it";
    ASSERT_TRUE(exploration->bestProbe()) << "but what it would buy is known";
    EXPECT_EQ(exploration->bestProbe()->bin, kBin06);
    EXPECT_EQ(exploration->bestProbe()->sd, stepEstimate().sd[kBin06]);
    EXPECT_FALSE(exploration->whyNotOffered());
    const int once = estimates;
    tick(50);
    ASSERT_TRUE(settles());
    EXPECT_EQ(estimates, once);
    exploration->request();
    Message stopsNothing;
    QObject::connect(exploration.get(), &Exploration::stoppedNothing,
                     [&stopsNothing](const Message& why) { stopsNothing = why; });
    exploration->stop();
    exploration->drive(+1);
    exploration->releaseStop();
    tick(3);
    exploration->leave();
    EXPECT_TRUE(source.consumeCommands().empty());
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    EXPECT_FALSE(stopsNothing.empty());
    EXPECT_EQ(exploration->stopViewState().state, StopViewState::State::NoEffect);
}

TEST_F(PassiveExplorationBench, updatesTheEstimateWithAReadingAndScoresItOnce)
{
    robotPresses();
    const ArmReading reading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    ASSERT_TRUE(probes(reading));
    EXPECT_EQ(exploration->estimation().estimate()->side[0].origin[kBin06], Origin::Arm);
    EXPECT_EQ(lastAsked().arm, std::vector{reading});
    tick(20);
    EXPECT_EQ(phase(), AtemPhase::Presenting) << "the same reading is no news";
    ASSERT_EQ(exploration->estimation().ledger().entries().size(), 1U);
    const ArmReading second{.bin = kBin06 + 1, .height = -0.05, .sd = 0.03};
    ASSERT_TRUE(probes(second));
    EXPECT_EQ(lastAsked().arm, (std::vector{reading, second}));
    EXPECT_EQ(exploration->estimation().ledger().entries().size(), 2U);
}

TEST_F(PassiveExplorationBench, secondMethodWaitsForTheEstimateUnderWay)
{
    robotPresses();
    blocked = true;
    telemetry.activity = RobotActivity::Probing;
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    ASSERT_TRUE(reaches(AtemPhase::EstimatingAgain));
    exploration->setSecondMethod(Method::Joint);
    tick(3);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().second().has_value();
    }));
}

TEST_F(PassiveExplorationBench, resultForADroppedSceneIsIgnored)
{
    blocked = true;
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    ASSERT_TRUE(answerIsQueued());
    telemetry.activity = RobotActivity::Pressing;
    tick();
    ASSERT_EQ(phase(), AtemPhase::Pressing);
    ASSERT_FALSE(exploration->estimation().scene());
    QCoreApplication::processEvents();
    EXPECT_FALSE(exploration->estimation().estimate());
}

TEST_F(PassiveExplorationBench, readingThatOvertakesTheEstimateWaitsForIt)
{
    blocked = true;
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    telemetry.activity = RobotActivity::Probing;
    tick(3);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::Estimating);
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::EstimatingAgain));
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(exploration->estimation().ledger().entries().size(), 1U)
        << "scored against the first";
}

TEST_F(PassiveExplorationBench, forgetsWhenTheRobotDrivesOnAndCapturesTheNextPress)
{
    robotPresses();
    telemetry.activity = RobotActivity::Driving;
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_TRUE(mentions(exploration->whyNoEstimate(), "has moved"));
    telemetry.pitch = 0.05;
    robotPresses();
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.05);
}

TEST_F(PassiveExplorationBench, clearsWhatItShowsUntilTheNextPress)
{
    robotPresses();
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_FALSE(exploration->estimation().estimate());
    const int before = estimates;
    tick(20);
    EXPECT_EQ(phase(), AtemPhase::Idle);
    EXPECT_EQ(estimates, before);
    robotPresses();
    EXPECT_TRUE(exploration->estimation().estimate());
}

TEST_F(PassiveExplorationBench, trustsNothingFromBeforeALostLink)
{
    robotPresses();
    tickInSilence(10);
    EXPECT_EQ(exploration->state().failure, AtemFailure::LinkLost);
    EXPECT_FALSE(exploration->estimation().estimate());
    telemetry.pitch = 0.05;
    ASSERT_TRUE(reaches(AtemPhase::Presenting)) << "it is pressed, and that is news";
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.05)
        << "not a line from before";
}

TEST_F(PassiveExplorationBench, showsAStopOfAnotherConsole)
{
    robotPresses();
    telemetry.activity = RobotActivity::Stopped;
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    tick(20);
    telemetry.activity = RobotActivity::Halted;
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    tick(20);
    EXPECT_TRUE(source.consumeCommands().empty());
}

}  // namespace
}  // namespace terratact
