#include "core/atem/console_link.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/benches/console_on_wire.h"

namespace terratact {
namespace {

TEST_F(Wire, measuresAt20HzAndSendsOnlyHeartbeats)
{
    pass(1.0);
    ASSERT_TRUE(latest);
    EXPECT_EQ(latest->activity, RobotActivity::Halted);
    EXPECT_NEAR(static_cast<double>(console.telemetry().counters().lines), 20.0, 1.0);
    EXPECT_NEAR(static_cast<double>(sent.size()), 10.0, 1.0);
    EXPECT_EQ(console.telemetry().counters().faults, decltype(TelemetryCounters::faults){});
    for (const CanFrame& frame : sent) EXPECT_EQ(frame.id, 27U);
}

TEST_F(Wire, armsByTwoActionsOverALinkThatWasGoodForASecond)
{
    pass(0.5);
    console.wantArming();
    console.confirmArming();
    pass(0.1);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::LinkNotGood);
    pass(2.0);
    console.confirmArming();
    pass(0.1);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed) << "the second action alone";
    EXPECT_EQ(command(DriveCommand{0.2}), GateRefusal::NotArmed);
    arm();
    EXPECT_TRUE(robot.armed());
    EXPECT_EQ(console.view(now).arming.epoch, robot.epoch());
}

TEST_F(Wire, repeatsADriveUntilAnotherCommand)
{
    arm();
    const double before = robot.robot().pose().base.x;
    EXPECT_EQ(command(DriveCommand{0.3}), GateRefusal::None);
    pass(4.0);
    EXPECT_EQ(activity(), RobotActivity::Driving);
    EXPECT_GT(robot.robot().pose().base.x, before + 0.5);
    EXPECT_EQ(command(HaltCommand{}), GateRefusal::None);
    pass(0.1);
    EXPECT_EQ(activity(), RobotActivity::Halted);
    const auto drives = std::ranges::count(sent, 20U, &CanFrame::id);
    EXPECT_NEAR(static_cast<double>(drives), 4.0 / ConsoleLink::kDrivePeriod, 5.0);
    pass(1.0);
    EXPECT_EQ(std::ranges::count(sent, 20U, &CanFrame::id), drives) << "a drive after its halt";
}

TEST_F(Wire, robotHaltsWhenTheConsoleDies)
{
    arm();
    command(DriveCommand{0.3});
    pass(1.0);
    ASSERT_EQ(activity(), RobotActivity::Driving);
    const double died = now;
    while (activity() == RobotActivity::Driving && now < died + 5.0)
        toConsole(robot.tick(now += 0.01));
    EXPECT_LE(now - died, 0.3);
    while (robot.armed() && now < died + 5.0) toConsole(robot.tick(now += 0.01));
    EXPECT_LE(now - died, 0.4) << "still armed";
}

TEST_F(Wire, absentOperatorEndsDriveAndArming)
{
    arm();
    command(DriveCommand{0.3});
    pass(1.0);
    operatorThere = false;
    const double frozen = now;
    pass(0.12);
    EXPECT_EQ(activity(), RobotActivity::Halted) << "halted after " << now - frozen;
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::OperatorAbsent);
    const std::size_t before = sent.size();
    pass(1.0);
    EXPECT_EQ(sent.size(), before) << "neither drives nor heartbeats";
    operatorThere = true;
    pass(3.0);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed) << "it armed by itself";
    EXPECT_NE(activity(), RobotActivity::Driving);
}

TEST_F(Wire, frozenWindowOnlyPausesWhileNothingMoves)
{
    arm();
    operatorThere = false;
    pass(0.9);
    EXPECT_EQ(phase(), ArmingPhase::Armed);
    EXPECT_EQ(command(DriveCommand{0.2}), GateRefusal::OperatorAbsent);
    EXPECT_EQ(command(PressCommand{18.0}), GateRefusal::OperatorAbsent);
    operatorThere = true;
    pass(0.1);
    EXPECT_EQ(phase(), ArmingPhase::Armed);
    EXPECT_EQ(activity(), RobotActivity::Halted) << "nothing was caught up on";
    EXPECT_EQ(command(DriveCommand{0.2}), GateRefusal::None);
    pass(0.1);
    EXPECT_EQ(activity(), RobotActivity::Driving);
}

TEST_F(Wire, windowFrozenForOverASecondDisarms)
{
    arm();
    operatorThere = false;
    pass(1.1);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::OperatorAbsent);
}

TEST_F(Wire, frozenWindowDisarmsAtOnceWhileArmOrFlippersMove)
{
    arm();
    command(BeginAtemCommand{});
    pass(0.1);
    ASSERT_EQ(command(PressCommand{18.0}), GateRefusal::None);
    operatorThere = false;
    pass(0.12);
    EXPECT_EQ(cause(), DisarmCause::OperatorAbsent) << "told to press, of which no status says yet";
}

TEST_F(Wire, frozenWindowPausesInAnExplorationAtRest)
{
    arm();
    command(BeginAtemCommand{});
    pass(0.1);
    ASSERT_EQ(command(PressCommand{18.0}), GateRefusal::None);
    ASSERT_TRUE(does(RobotActivity::Pressed, 15.0));
    pass(0.6);
    operatorThere = false;
    pass(0.9);
    EXPECT_EQ(phase(), ArmingPhase::Armed);
    EXPECT_EQ(activity(), RobotActivity::Pressed);
    operatorThere = true;
    pass(0.1);
    console.approve({4}, now);
    EXPECT_EQ(command(ProbeCommand{4}), GateRefusal::None);
    pass(0.2);
    operatorThere = false;
    pass(0.12);
    EXPECT_EQ(cause(), DisarmCause::OperatorAbsent) << "the arm moves";
}

TEST_F(Wire, cutWireDisarmsBothAndNothingStartsAgain)
{
    arm();
    command(DriveCommand{0.3});
    pass(0.5);
    cut = true;
    pass(0.4);
    EXPECT_EQ(activity(), RobotActivity::Halted);
    EXPECT_FALSE(robot.armed());
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::LinkNotGood);
    cut = false;
    pass(3.0);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(activity(), RobotActivity::Halted);
    EXPECT_EQ(command(DriveCommand{0.3}), GateRefusal::NotArmed);
    arm();
    EXPECT_EQ(command(DriveCommand{0.3}), GateRefusal::None);
}

TEST_F(Wire, framesDelayedByAnOutageAreVoid)
{
    arm();
    std::vector<CanFrame> stale;
    lose = [&](const CanFrame& frame) {
        stale.push_back(frame);
        return true;
    };
    command(DriveCommand{0.3});
    pass(2.0);
    lose = nullptr;
    ASSERT_GT(stale.size(), 5U);
    for (const CanFrame& frame : stale) toConsole(robot.receive(frame, now));
    toConsole(robot.tick(now += 0.01));
    EXPECT_EQ(activity(), RobotActivity::Halted);
    EXPECT_FALSE(robot.armed());
}

TEST_F(Wire, recordedHourOfTelemetryArmsNothing)
{
    std::vector<std::vector<CanFrame>> recording;
    for (int i = 0; i < 80; ++i) {
        robot.receive(consoleHeartbeat(7, static_cast<std::uint8_t>(i)), now);
        recording.push_back(robot.tick(now += 0.05));
    }
    const double began = now;
    for (const auto& frames : recording) {
        console.operatorAlive(now += 0.05);
        for (const CanFrame& frame : frames) console.receive(frame, false, now);
        console.tick(now);
    }
    EXPECT_GT(now - began, 3.0);
    EXPECT_EQ(console.view(now).state, LinkState::Good);
    console.wantArming();
    console.tick(now);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::LinkNotGood) << "nobody answered the heartbeats";
}

TEST_F(Wire, stopWorksDisarmedAndLatchesUntilReleased)
{
    pass(0.5);
    EXPECT_EQ(command(StopCommand{}), GateRefusal::None);
    pass(0.1);
    EXPECT_EQ(activity(), RobotActivity::Stopped);
    pass(2.0);
    console.wantArming();
    pass(0.05);
    EXPECT_EQ(cause(), DisarmCause::Stop);
    EXPECT_EQ(command(ReleaseStopCommand{}), GateRefusal::None);
    pass(0.2);
    EXPECT_EQ(activity(), RobotActivity::Halted);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed) << "a release arms nothing";
}

TEST_F(Wire, refusedReleaseReleasesNothing)
{
    arm();
    cut = true;
    pass(1.0);
    command(StopCommand{});
    EXPECT_NE(command(ReleaseStopCommand{}), GateRefusal::None) << "there is no link";
    EXPECT_TRUE(console.stopLatched());
}

TEST_F(Wire, stopUnknownToTheRobotIsReleasedLocally)
{
    arm();
    cut = true;
    command(StopCommand{});
    cut = false;
    pass(2.0);
    EXPECT_EQ(command(ReleaseStopCommand{}), GateRefusal::NotStopped);
    EXPECT_FALSE(console.stopLatched());
}

TEST_F(Wire, pressWorksWhileTheLastDriveTimesOut)
{
    arm();
    ASSERT_EQ(command(DriveCommand{0.3}), GateRefusal::None);
    pass(0.3);
    ASSERT_EQ(command(BeginAtemCommand{}), GateRefusal::None);
    pass(0.1);
    ASSERT_EQ(command(PressCommand{18.0}), GateRefusal::None);
    pass(0.3);
    EXPECT_EQ(activity(), RobotActivity::Pressing);
}

TEST_F(Wire, damagedStopStopsToo)
{
    arm();
    command(DriveCommand{0.3});
    pass(0.2);
    auto frame = std::get<CanFrame>(console.send(StopCommand{}, now));
    frame.data[0] ^= 0xFFU;
    frame.length = 3;
    toRobot({frame});
    EXPECT_EQ(activity(), RobotActivity::Stopped);
}

TEST_F(Wire, foreignConsoleDisarmsAtItsFirstFrame)
{
    arm();
    console.receive(frameOf(DriveCommand{0.1}, robot.epoch(), 200), false, now);
    pass(0.01);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(cause(), DisarmCause::ForeignSender);
    pass(2.0);
    console.wantArming();
    pass(0.01);
    EXPECT_EQ(cause(), DisarmCause::ForeignSender) << "it is remembered for a while";
    pass(ConsoleLink::kForeignFor);
    arm();
}

TEST_F(Wire, explorationWithAProbeNeedsItsApproval)
{
    arm();
    EXPECT_EQ(command(PressCommand{18.0}), GateRefusal::NotExploring);
    ASSERT_EQ(command(BeginAtemCommand{}), GateRefusal::None);
    pass(0.1);
    EXPECT_EQ(command(DriveCommand{0.2}), GateRefusal::Exploring);
    ASSERT_EQ(command(PressCommand{18.0}), GateRefusal::None);
    ASSERT_TRUE(does(RobotActivity::Pressed, 15.0));
    constexpr int kAsked = 9;
    EXPECT_EQ(command(ProbeCommand{kAsked}), GateRefusal::NotApproved);
    console.approve({kAsked - 1}, now);
    EXPECT_EQ(command(ProbeCommand{kAsked}), GateRefusal::OtherBin);
    console.approve({kAsked, ProbeSide::Left}, now);
    EXPECT_EQ(command(ProbeCommand{kAsked}), GateRefusal::OtherBin);
    console.approve({kAsked}, now);
    EXPECT_EQ(command(ProbeCommand{kAsked, ProbeSide::Left}), GateRefusal::OtherBin);
    EXPECT_EQ(command(ProbeCommand{kAsked - 1}), GateRefusal::NotApproved)
        << "an approval is for one try";
    console.approve({kAsked}, now);
    pass(30.1);
    EXPECT_EQ(command(ProbeCommand{kAsked}), GateRefusal::ApprovalExpired);
    console.approve({kAsked}, now);
    ASSERT_EQ(command(ProbeCommand{kAsked}), GateRefusal::None);
    ASSERT_TRUE(does(RobotActivity::Probing, 1.0));
    ASSERT_TRUE(does(RobotActivity::Pressed, 5.0));
    ASSERT_TRUE(latest->arm);
    EXPECT_EQ(latest->arm->bin, kAsked);
    EXPECT_NEAR(latest->arm->height, robot.robot().truth()[kAsked], 0.15);
    EXPECT_EQ(command(AbortAtemCommand{}), GateRefusal::None);
    pass(0.1);
    EXPECT_EQ(command(DriveCommand{0.2}), GateRefusal::None);
}

struct Reboot : Wire {
    Reboot() : Wire({.fault = RobotFault::Reboot, .faultAt = 6.0}) {}
};
TEST_F(Reboot, ofTheRobotDisarmsTheConsole)
{
    arm();
    command(DriveCommand{0.2});
    pass(5.0);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    EXPECT_EQ(activity(), RobotActivity::Halted);
    arm();
}

struct Silence : Wire {
    Silence() : Wire({.fault = RobotFault::Silence, .faultAt = 4.0}) {}
};
TEST_F(Silence, ofTheRobotIsALostLink)
{
    arm();
    pass(3.0);
    EXPECT_EQ(console.view(now).state, LinkState::Lost);
    EXPECT_EQ(cause(), DisarmCause::LinkNotGood);
    EXPECT_EQ(command(StopCommand{}), GateRefusal::None) << "a stop leaves whatever the link";
}

struct DeadElement : Wire {
    DeadElement() : Wire({.fault = RobotFault::DeadElement}) {}
};
TEST_F(DeadElement, isNamedAndTheOtherBinServes)
{
    pass(0.5);
    ASSERT_TRUE(latest);
    const auto& element = console.telemetry().forces().left[3];
    ASSERT_TRUE(element);
    EXPECT_EQ(element->state, ElementState::Open);
    EXPECT_EQ(console.telemetry().forces().right[3]->state, ElementState::Sound);
}

struct StuckImu : Wire {
    StuckImu() : Wire({.fault = RobotFault::StuckImu}) {}
};
TEST_F(StuckImu, repeatsItsPitchToTheLastBit)
{
    pass(0.2);
    ASSERT_TRUE(latest);
    const double pitch = latest->pitch;
    const double angle = latest->frontLeft;
    int same = 0;
    for (int i = 0; i < 20; ++i) {
        pass(0.05);
        EXPECT_EQ(latest->pitch, pitch);
        same += latest->frontLeft == angle ? 1 : 0;
    }
    EXPECT_LT(same, 20) << "the rest is noisy as ever";
}

struct RefuseProbe : Wire {
    RefuseProbe() : Wire({.fault = RobotFault::RefuseProbe}) {}
};
TEST_F(RefuseProbe, isReportedInTheStatus)
{
    beginProbe(9);
    pass(0.1);
    EXPECT_EQ(latest->refusal, Refusal::OutOfReach);
    EXPECT_EQ(console.view(now).robot->lastCommand, FrameKind::ProbeBin);
}

struct SlowArm : Wire {
    SlowArm() : Wire({.fault = RobotFault::SlowArm}) {}
};
TEST_F(SlowArm, needsThreeTimesAsLong)
{
    beginProbe(9);
    pass(5.8);
    EXPECT_EQ(activity(), RobotActivity::Probing) << "2 s without the fault";
    pass(0.4);
    EXPECT_EQ(activity(), RobotActivity::Pressed);
}

TEST(RobotOnBus, refusesWrongOptions)
{
    const auto make = [](RobotOnBus::Options options) {
        return RobotOnBus(absolem(), robotBefore(1.5), options);
    };
    EXPECT_THROW(make({.firstEpoch = 0}), std::invalid_argument);
    EXPECT_THROW(make({.speed = 0.0}), std::invalid_argument);
    EXPECT_THROW(make({.faultAt = -1.0}), std::invalid_argument);
    for (const RobotFault fault : kRobotFaults) EXPECT_EQ(robotFaultFromName(name(fault)), fault);
    EXPECT_FALSE(robotFaultFromName("fire"));
}

}  // namespace
}  // namespace terratact
