// Tests feel forward: what goes on by itself, what ends it, and what the robot is sent.
#include "app/display/translated.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

/// A robot that obeys: it presses, and advances 0.02 m per line of telemetry.
struct LoopBench : Bench {
    LoopBench()
    {
        clear = true;
        telemetry.travelled = 3.0;
        telemetry.activity = RobotActivity::Halted;
        tick(3);
    }

    void step()
    {
        tick();
        QCoreApplication::processEvents();
        (void)sent<HaltCommand>();
        for (; heard_ < all.size(); ++heard_) obey(all[heard_]);
        if (telemetry.activity != RobotActivity::Driving) return;
        const double moved = std::min(0.02, left_);
        telemetry.travelled = *telemetry.travelled + share * moved;
        left_ -= moved;
        if (left_ <= 1e-9 && !rolls) telemetry.activity = RobotActivity::Halted;
    }
    bool comesTo(AtemPhase wanted)
    {
        return gui::eventually([&] {
            step();
            return phase() == wanted;
        });
    }
    bool ends()
    {
        return gui::eventually([&] {
            step();
            return !exploration->state().loops;
        });
    }
    bool tells(const QString& text) const { return events.join('\n').contains(text); }
    LoopEnd end() const { return exploration->state().loopEnd; }

    double share = 1.0;  ///< of the true way that the odometry reports
    bool rolls = false;  ///< does not halt after an advance
    bool refuses = false;

private:
    void obey(const Command& command)
    {
        if (std::holds_alternative<PressCommand>(command))
            telemetry.activity = RobotActivity::Pressed;
        if (const auto* advance = std::get_if<AdvanceCommand>(&command)) {
            left_ = rolls ? 10.0 : advance->distance;
            telemetry.activity = RobotActivity::Driving;
            if (refuses) telemetry.refusal = Refusal::Busy;
        }
        if (safety(command) > 0) {
            left_ = 0.0;
            telemetry.activity = RobotActivity::Halted;
        }
    }
    std::size_t heard_ = 0;
    double left_ = 0.0;  ///< [m] of the advance
};

TEST_F(LoopBench, goesOnWhileItIsHeldAndTheWayIsClear)
{
    exploration->feelForward();
    ASSERT_TRUE(gui::eventually([&] {
        step();
        return sent<AdvanceCommand>() == 3;
    }));
    EXPECT_EQ(sent<PressCommand>(), 3);
    EXPECT_EQ(sent<BeginAtemCommand>(), 3);
    EXPECT_EQ(sent<AbortAtemCommand>(), 3) << "each exploration ends before the robot moves";
    EXPECT_NEAR(exploration->pace().way, 2.0 * kAdvance, 1e-9);
    EXPECT_GT(exploration->pace().metresPerMinute(now), 0.0);
    EXPECT_TRUE(exploration->state().loops);
    EXPECT_TRUE(mentions(exploration->stateText(), "feel forward: advancing"));
    EXPECT_TRUE(tells("advancing 0.1 m: CLEAR for 0.30 m ahead of the tracks"));
    ASSERT_TRUE(comesTo(AtemPhase::Halting));
    EXPECT_NEAR(exploration->pace().way, 3.0 * kAdvance, 1e-9);
}

TEST_F(LoopBench, anAdvanceIsNotTakenForADrive)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    EXPECT_TRUE(exploration->whyNotDriving());
    EXPECT_TRUE(exploration->whyNotFeelingForward()) << "it is going on";
    exploration->drive(+1);
    step();
    EXPECT_EQ(sent<DriveCommand>(), 0);
}

TEST_F(LoopBench, lettingGoHaltsAtOnceInEveryMovingPhase)
{
    for (const AtemPhase in : {AtemPhase::Advancing, AtemPhase::Pressing, AtemPhase::Halting}) {
        exploration->feelForward();
        ASSERT_TRUE(comesTo(in)) << name(in);
        const int halts = sent<HaltCommand>(), advances = sent<AdvanceCommand>();
        exploration->letGo();
        EXPECT_EQ(sent<HaltCommand>(), halts + 1) << "before any tick, " << name(in);
        step();
        EXPECT_EQ(phase(), AtemPhase::Idle) << name(in);
        EXPECT_EQ(end(), LoopEnd::LetGo);
        for (int i = 0; i < 50; ++i) step();
        EXPECT_EQ(sent<AdvanceCommand>(), advances) << name(in);
        EXPECT_EQ(phase(), AtemPhase::Idle);
    }
    EXPECT_TRUE(tells("the control was let go"));
}

TEST_F(LoopBench, lettingGoWhileItEstimatesKeepsTheResult)
{
    blocked = true;
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Estimating));
    exploration->letGo();
    step();
    EXPECT_EQ(end(), LoopEnd::LetGo);
    blocked = false;
    ASSERT_TRUE(comesTo(AtemPhase::Presenting));
    for (int i = 0; i < 50; ++i) step();
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    EXPECT_EQ(sent<AdvanceCommand>(), 0);
}

TEST_F(LoopBench, aClickThatIsLetGoBeforeTheTickMovesNothing)
{
    exploration->feelForward();
    exploration->letGo();
    for (int i = 0; i < 20; ++i) step();
    EXPECT_EQ(phase(), AtemPhase::Idle);
    EXPECT_EQ(sent<BeginAtemCommand>(), 0);
}

TEST_F(LoopBench, goesOnFromAResultThatIsClear)
{
    exploration->request();
    ASSERT_TRUE(comesTo(AtemPhase::Presenting));
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    EXPECT_EQ(sent<PressCommand>(), 1) << "what was felt at this pose still stands";
}

TEST_F(LoopBench, stopsAndAsksWhereTheGroundIsNotFelt)
{
    clear = false;
    withDraws = true;
    exploration->feelForward();
    ASSERT_TRUE(ends());
    EXPECT_EQ(end(), LoopEnd::Blocked);
    EXPECT_EQ(phase(), AtemPhase::Presenting);
    EXPECT_EQ(sent<AdvanceCommand>(), 0);
    EXPECT_TRUE(tells("feel forward has ended after 0.00 m"));
    EXPECT_TRUE(mentions(exploration->stateText(), "BLOCKED: there is a step ahead"));
    for (int i = 0; i < 50; ++i) step();
    EXPECT_EQ(sent<PressCommand>(), 1) << "a held control begins nothing new";
}

TEST_F(LoopBench, proposesAProbeThatWouldDecide)
{
    clear = false;
    withDraws = stepInHalf = true;
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::ProposingProbe));
    EXPECT_EQ(end(), LoopEnd::ProbeProposed);
    ASSERT_TRUE(exploration->proposal());
    exploration->letGo();
    step();
    EXPECT_EQ(phase(), AtemPhase::ProposingProbe) << "the question needs no hold";
    clear = true;
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(comesTo(AtemPhase::Presenting));
}

TEST_F(LoopBench, proposesNoProbeWhileTheWayIsClear)
{
    exploration->request();
    ASSERT_TRUE(comesTo(AtemPhase::ProposingProbe)) << "a single exploration offers one: sd 0.09 m";
    exploration->refuse(exploration->proposal()->id);
    exploration->feelForward();
    ASSERT_FALSE(exploration->state().loops);
    ASSERT_TRUE(comesTo(AtemPhase::Presenting));
    exploration->letGo();
    exploration->feelForward();
    ASSERT_TRUE(gui::eventually([&] {
        step();
        return sent<AdvanceCommand>() == 2;
    }));
}

TEST_F(LoopBench, aRobotThatDoesNotMoveFails)
{
    share = 0.0;
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::NotMoved);
    EXPECT_EQ(end(), LoopEnd::Fault);
}

TEST_F(LoopBench, aRobotThatRunsOnIsHalted)
{
    rolls = true;
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::RanOn);
    EXPECT_TRUE(std::holds_alternative<AbortAtemCommand>(all.back())) << "which halts";
}

TEST_F(LoopBench, aRefusedAdvanceFailsWithTheRobotsReason)
{
    refuses = true;
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::AdvanceRefused);
    EXPECT_TRUE(mentions(exploration->stateText(), "the advance was refused"));
}

TEST_F(LoopBench, anAdvanceThatCannotBeSentFails)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Presenting));
    source.setDeaf(true);
    ASSERT_TRUE(comesTo(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::NotSent);
    EXPECT_TRUE(mentions(exploration->stateText(), "the bus is off"));
}

TEST_F(LoopBench, staleTelemetryEndsAnAdvance)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    tickInSilence(5);
    EXPECT_EQ(phase(), AtemPhase::Failed);
    EXPECT_EQ(exploration->state().failure, AtemFailure::LinkLost);
    (void)sent<AbortAtemCommand>();
    EXPECT_TRUE(std::holds_alternative<AbortAtemCommand>(all.back())) << "which halts";
}

TEST_F(LoopBench, aTiltEndsAnAdvance)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    telemetry.pitch = 0.5;
    step();
    EXPECT_EQ(phase(), AtemPhase::Idle);
    EXPECT_EQ(end(), LoopEnd::Attitude);
    EXPECT_TRUE(mentions(exploration->stateText(), "pitch or roll is near its limit"));
}

TEST_F(LoopBench, stopEndsItAndIsSentAtOnce)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    exploration->stop();
    EXPECT_EQ(sent<StopCommand>(), 1);
    step();
    EXPECT_EQ(phase(), AtemPhase::Stopped);
    EXPECT_EQ(end(), LoopEnd::Stop);
}

TEST_F(LoopBench, needsOdometry)
{
    telemetry.travelled.reset();
    tick();
    EXPECT_TRUE(mentions(exploration->whyNotFeelingForward(), "the robot reports no odometry"));
    exploration->feelForward();
    tick(3);
    EXPECT_EQ(phase(), AtemPhase::Idle);
}

TEST_F(LoopBench, leavingTheConsoleHaltsIt)
{
    exploration->feelForward();
    ASSERT_TRUE(comesTo(AtemPhase::Advancing));
    const int halts = sent<HaltCommand>();
    exploration->leave();
    EXPECT_EQ(sent<HaltCommand>(), halts + 1);
}

}  // namespace
}  // namespace terratact
