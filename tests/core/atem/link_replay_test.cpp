#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/benches/console_on_wire.h"

namespace terratact {
namespace {

constexpr std::uint32_t kArm = 0x12, kHalt = 0x13, kDrive = 0x14, kHeartbeat = 0x1B;

/// A bus that delivers valid frames late, twice, in another order, or long after.
struct Replay : Wire {
    void press(double speed, double seconds)
    {
        ASSERT_EQ(command(DriveCommand{speed}), GateRefusal::None);
        pass(seconds);
    }
    void release() { ASSERT_EQ(command(HaltCommand{}), GateRefusal::None); }
    std::vector<CanFrame> drives() const
    {
        std::vector<CanFrame> all;
        std::ranges::copy_if(sent, std::back_inserter(all),
                             [](const CanFrame& frame) { return frame.id == kDrive; });
        return all;
    }
    /// Replays one frame every 20 ms, which the console does not receive.
    void replay(const std::vector<CanFrame>& frames)
    {
        for (const CanFrame& frame : frames) {
            arrive(frame);
            pass(0.02);
        }
    }
};

TEST_F(Replay, lateDrivesAfterAHaltMoveNothing)
{
    arm();
    press(0.6, 1.0);
    std::vector<CanFrame> late;
    lose = [&](const CanFrame& frame) {
        if (frame.id == kDrive) late.push_back(frame);
        return frame.id == kDrive;
    };
    pass(0.04);
    lose = nullptr;
    release();
    const double halted = x();
    ASSERT_EQ(late.size(), 2U);
    for (const CanFrame& frame : late) arrive(frame);
    pass(1.0);
    EXPECT_EQ(x() - halted, 0.0);
    EXPECT_TRUE(robot.armed());
}

TEST_F(Replay, oldDrivesOfThisArmingMoveNothing)
{
    arm();
    press(0.6, 1.02);
    release();
    pass(1.0);
    const double halted = x();
    ASSERT_GE(drives().size(), 51U);
    replay(drives());
    pass(1.0);
    EXPECT_EQ(x() - halted, 0.0);
    EXPECT_TRUE(robot.armed());
}

TEST_F(Replay, oldDrivesNeverTurnANewKeyPress)
{
    arm();
    press(0.6, 1.0);
    release();
    pass(0.5);
    const std::vector<CanFrame> forward = drives();
    press(-0.3, 0.1);
    for (const CanFrame& frame : forward) {
        const double before = x();
        arrive(frame);
        pass(0.02);
        EXPECT_LE(x(), before);
    }
    EXPECT_EQ(activity(), RobotActivity::Driving);
}

TEST_F(Replay, everyCommandOfAnArmingIsVoidInTheNext)
{
    arm();
    press(0.6, 0.5);
    release();
    const std::vector<CanFrame> recorded = sent;
    const std::uint8_t epoch = robot.epoch();
    do arrive(frameOf(ArmCommand{false}, 0, 0));
    while (robot.epoch() + 1 != epoch);
    arm();
    ASSERT_EQ(robot.epoch(), epoch) << "the same again, 255 later";
    const double halted = x();
    for (const CanFrame& frame : recorded)
        if (frame.id != kHeartbeat && frame.id != kHalt) replay({frame});
    EXPECT_EQ(x() - halted, 0.0);
    EXPECT_TRUE(robot.armed());
}

TEST_F(Replay, aRecordedSessionDoesNotArmARobot)
{
    arm();
    press(0.6, 0.5);
    release();
    RobotOnBus::Options other;  // the same epoch, by chance
    other.firstChallenge = 4711;
    RobotOnBus restarted(absolem(), robotBefore(1.5), other);
    const double halted = restarted.robot().pose().base.x;
    for (const CanFrame& frame : sent) {
        restarted.tick(now += 0.01);
        restarted.receive(frame, now);
        EXPECT_FALSE(restarted.armed());
    }
    EXPECT_EQ(restarted.robot().pose().base.x - halted, 0.0);
}

/// Two key presses on a bus that loses, delays and duplicates frames; old frames come all the time.
/// Once a Halt has reached the robot, it stands until a newer press.
struct RandomBus : Replay {
    std::vector<double> fate(const CanFrame& frame)
    {
        const bool spared = frame.id == kHeartbeat && heartbeatsAreSpared;
        if (spared) return {0.0};
        const double dice = uniform(random);
        if (dice < 0.1) return {};
        if (dice < 0.5) return {0.0};
        if (dice < 0.8) return {0.5 * uniform(random)};
        return {0.05 * uniform(random), 2.0 * uniform(random)};
    }
    void passUnderReplay(double seconds, const std::function<void()>& check)
    {
        for (double end = now + seconds; now < end;) {
            pass(0.01);
            const CanFrame& old = sent[random() % sent.size()];
            const bool spared = old.id == kHeartbeat && heartbeatsAreSpared;
            if (old.id != kHalt && !spared && uniform(random) < 0.7) arrive(old);
            check();
        }
    }
    void run(unsigned seed)
    {
        random.seed(seed);
        heartbeatsAreSpared = seed % 4 != 0;
        arm();
        delays = [this](const CanFrame& frame) { return fate(frame); };
        for (const double speed : {0.6, -0.4, 0.5}) {
            command(DriveCommand{speed});
            passUnderReplay(0.2 + uniform(random), [] {});
            command(HaltCommand{});
            arrive(sent.back());
            const double halted = x();
            double moved = 0.0;
            passUnderReplay(1.5, [&] { moved = std::max(moved, std::abs(x() - halted)); });
            EXPECT_EQ(moved, 0.0) << "m, seed " << seed;
        }
        stayedArmed += robot.armed() ? 1 : 0;
    }

    std::mt19937 random;
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    bool heartbeatsAreSpared = true;
    int stayedArmed = 0;
};

TEST(RandomBuses, standStillOnceAHaltHasArrived)
{
    int armed = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        struct Run : RandomBus {
            void TestBody() override {}
        } bus;
        bus.run(seed);
        if (HasFatalFailure() || HasNonfatalFailure()) break;
        armed += bus.stayedArmed;
    }
    EXPECT_GE(armed, 25) << "nothing was tried on a robot that would drive";
}

TEST_F(Replay, armDelayedBy20SecondsArmsNothing)
{
    delays = [](const CanFrame& frame) {
        return frame.id == kArm ? std::vector<double>{} : std::vector<double>{0.0};
    };
    pass(2.5);
    console.wantArming();
    pass(0.2);
    console.confirmArming();
    pass(0.2);
    console.disarm();
    pass(19.6);
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    delays = nullptr;
    const auto arming = std::ranges::find_if(sent, [](const CanFrame& f) { return f.id == kArm; });
    ASSERT_NE(arming, sent.end());
    const CanFrame late = *arming;
    arrive(late);
    EXPECT_FALSE(robot.armed());
}

TEST_F(Replay, disarmedConsoleDisarmsARobotThatArmedTooLate)
{
    int arms = 0;
    delays = [&](const CanFrame& frame) {
        if (frame.id != kArm) return std::vector<double>{0.0};
        ++arms;
        if (arms == 1) return std::vector<double>{0.2};                      // the Arm
        return arms < 5 ? std::vector<double>{} : std::vector<double>{0.0};  // Disarms are lost
    };
    pass(2.5);
    console.wantArming();
    pass(0.2);
    console.confirmArming();
    pass(0.05);
    console.disarm();
    pass(0.2);
    ASSERT_TRUE(robot.armed()) << "the Arm came after 0.2 s";
    pass(0.6);
    EXPECT_FALSE(robot.armed());
    EXPECT_EQ(phase(), ArmingPhase::Disarmed);
    const int told = arms;
    pass(1.0);
    EXPECT_EQ(arms, told) << "a robot that is disarmed is told no more";
}

TEST_F(Replay, aConsoleThatStartsAgainDisarmsTheRobot)
{
    arm();
    pass(0.05);
    console = ConsoleLink(absolem(), {.seed = 2});
    ASSERT_TRUE(robot.armed()) << "it was away for too short a time";
    pass(0.3);
    EXPECT_FALSE(robot.armed());
}

TEST_F(Replay, aRobotArmedByAnotherConsoleIsNotDisarmed)
{
    arm();
    ConsoleLink other(absolem(), {.seed = 2});
    int told = 0;
    for (int i = 0; i < 100; ++i) {
        pass(0.01);
        other.operatorAlive(now);
        other.receive(consoleHeartbeat(1, static_cast<std::uint8_t>(i)), false, now);
        for (const CanFrame& frame : robot.tick(now += 0.01)) {
            console.receive(frame, false, now);
            other.receive(frame, false, now);
        }
        for (const CanFrame& frame : other.tick(now)) told += frame.id == kArm ? 1 : 0;
    }
    ASSERT_TRUE(other.view(now).robot && other.view(now).robot->armed);
    EXPECT_EQ(told, 0);
}

TEST_F(Replay, aPressRightAfterAReleaseDrives)
{
    arm();
    press(0.3, 0.5);
    release();
    const double halted = x();
    press(-0.3, 0.05);  // the next tick has a challenge
    EXPECT_EQ(activity(), RobotActivity::Driving);
    EXPECT_LT(x(), halted);
    release();
    ASSERT_EQ(command(BeginAtemCommand{}), GateRefusal::None);
    pass(0.03);
    EXPECT_TRUE(console.view(now).robot);
    pass(0.1);
    EXPECT_TRUE(console.view(now).robot->exploring);
}

TEST_F(Replay, aWaitingDriveEndsWithItsKey)
{
    arm();
    press(0.3, 0.5);
    release();
    const double halted = x();
    ASSERT_EQ(command(DriveCommand{0.3}), GateRefusal::None);
    release();
    pass(1.0);
    EXPECT_EQ(x() - halted, 0.0);
    lose = [](const CanFrame& frame) { return frame.id == kHeartbeat; };
    ASSERT_EQ(command(HaltCommand{}), GateRefusal::None);
    ASSERT_EQ(command(DriveCommand{0.3}), GateRefusal::None);
    pass(0.24);
    lose = nullptr;
    pass(0.02);
    pass(1.0);
    EXPECT_EQ(x() - halted, 0.0) << "a command that waited 0.25 s left";
}

}  // namespace
}  // namespace terratact
