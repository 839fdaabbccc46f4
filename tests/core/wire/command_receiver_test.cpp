#include "core/wire/command_receiver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace terratact {
namespace {

using Silence = CommandReceiver::Silence;

struct RobotEnd : testing::Test {
    CommandVerdict send(const Command& command) { return send(command, robot.epoch()); }
    CommandVerdict send(const Command& command, std::uint8_t epoch)
    {
        return robot.receive(frameOf(command, epoch, next++, challenge), now).verdict;
    }
    void beat(int times)
    {
        for (int i = 0; i < times; ++i, now += 0.1)
            challenge = robot.receive(consoleHeartbeat(token, heartbeats++), now).challenge;
        now -= 0.1;
    }
    void arm()
    {
        beat(10);
        ASSERT_EQ(send(ArmCommand{true}), CommandVerdict::Accepted);
        ASSERT_TRUE(robot.armed());
        now += 0.1;
        beat(1);  // arming voids the challenge
    }
    CanFrame drive(std::uint8_t counter) const
    {
        return frameOf(DriveCommand{0.1}, robot.epoch(), counter, challenge);
    }

    CommandReceiver robot{7};
    double now = 50.0;
    std::uint8_t next = 0, heartbeats = 0;
    std::uint16_t token = 4711, challenge = 0;
};

TEST_F(RobotEnd, armsOnlyForAConsoleThatHasBeenAliveForAWhile)
{
    EXPECT_EQ(send(ArmCommand{true}), CommandVerdict::NoHeartbeat);
    beat(9);
    EXPECT_EQ(send(ArmCommand{true}), CommandVerdict::NoHeartbeat);
    now += 0.1;
    beat(1);
    EXPECT_EQ(send(DriveCommand{0.1}), CommandVerdict::NotArmed);
    EXPECT_EQ(send(ArmCommand{true}), CommandVerdict::Accepted);
    EXPECT_TRUE(robot.armed());
}

TEST_F(RobotEnd, answersValidHeartbeatsWithTheirToken)
{
    const auto answer = robot.receive(consoleHeartbeat(99, 0), now);
    EXPECT_EQ(answer.verdict, CommandVerdict::Heartbeat);
    EXPECT_EQ(answer.token, 99);
    EXPECT_EQ(robot.receive(consoleHeartbeat(98, 0), now).verdict, CommandVerdict::Repeated);
    EXPECT_EQ(robot.receive(consoleHeartbeat(97, 9), now).verdict, CommandVerdict::WrongSequence);
    CanFrame damaged = consoleHeartbeat(97, 10);
    damaged.data[6] ^= 1U;
    EXPECT_EQ(robot.receive(damaged, now).verdict, CommandVerdict::Malformed);
}

TEST_F(RobotEnd, beginsANewEpochWheneverItArmsDisarmsOrStops)
{
    std::uint8_t before = robot.epoch();
    const auto changed = [&] { return std::exchange(before, robot.epoch()) != robot.epoch(); };
    arm();
    EXPECT_TRUE(changed());
    send(ArmCommand{false});
    EXPECT_TRUE(changed());
    EXPECT_FALSE(robot.armed());
    arm();
    EXPECT_TRUE(changed());
    send(StopCommand{});
    EXPECT_TRUE(changed());
    EXPECT_FALSE(robot.armed());
    for (int i = 0; i < 600; ++i) {
        robot.disarm();
        ASSERT_TRUE(changed());
        ASSERT_NE(robot.epoch(), 0);
    }
    EXPECT_THROW(CommandReceiver(0), std::invalid_argument);
}

TEST_F(RobotEnd, takesEveryMotionOnceAndInOrder)
{
    arm();
    const std::uint8_t epoch = robot.epoch();
    EXPECT_EQ(robot.receive(drive(250), now).verdict, CommandVerdict::Accepted);
    EXPECT_EQ(robot.receive(drive(250), now).verdict, CommandVerdict::Repeated);
    EXPECT_EQ(robot.receive(drive(253), now).verdict, CommandVerdict::Accepted);
    EXPECT_EQ(robot.receive(drive(0), now).verdict, CommandVerdict::Accepted)
        << "over the counter's end";
    EXPECT_EQ(robot.receive(drive(4), now).verdict, CommandVerdict::WrongSequence);
    EXPECT_EQ(robot.receive(drive(250), now).verdict, CommandVerdict::WrongSequence);
    EXPECT_EQ(robot.receive(drive(251), now).verdict, CommandVerdict::WrongSequence)
        << "an old frame set the counter back";
    EXPECT_EQ(robot.receive(drive(5), now).verdict, CommandVerdict::Accepted);
    EXPECT_EQ(robot.receive(drive(5 + 128), now).verdict, CommandVerdict::WrongSequence)
        << "half a turn ahead is half a turn behind";
    EXPECT_EQ(robot.receive(drive(6), now).verdict, CommandVerdict::Accepted);
    EXPECT_EQ(robot.receive(drive(6 + 127), now).verdict, CommandVerdict::WrongSequence)
        << "many are missing";
    EXPECT_EQ(robot.receive(drive(6 + 128), now).verdict, CommandVerdict::Accepted)
        << "the next one";
    EXPECT_EQ(robot.receive(frameOf(ProbeCommand{7}, epoch, 99, challenge), now).verdict,
              CommandVerdict::Accepted)
        << "every kind has its own counter";
}

TEST_F(RobotEnd, needsAChallengeOfAtMostHalfASecond)
{
    arm();
    const std::uint16_t given = challenge;
    const double since = now;
    EXPECT_NE(given, 0);
    EXPECT_EQ(robot.receive(frameOf(DriveCommand{0.1}, robot.epoch(), 0, 0), now).verdict,
              CommandVerdict::TooLate)
        << "none";
    EXPECT_EQ(
        robot.receive(frameOf(DriveCommand{0.1}, robot.epoch(), 0, robot.nextChallenge()), now)
            .verdict,
        CommandVerdict::TooLate)
        << "one that was not given out";
    for (int i = 0; i < 4; ++i) {
        now += 0.1;
        beat(1);
        EXPECT_NE(challenge, given);
    }
    challenge = given;
    now = since + 0.499;
    EXPECT_EQ(send(DriveCommand{0.1}), CommandVerdict::Accepted);
    now = since + 0.501;
    EXPECT_EQ(send(DriveCommand{0.1}), CommandVerdict::TooLate);
    EXPECT_EQ(send(ArmCommand{true}), CommandVerdict::TooLate) << "an Arm expires, too";
    EXPECT_EQ(send(ReleaseStopCommand{}), CommandVerdict::TooLate);
    challenge = 0;
    EXPECT_EQ(send(ArmCommand{false}), CommandVerdict::Accepted) << "disarming needs none";
}

TEST_F(RobotEnd, voidsItsChallengesWhereverItHalts)
{
    const auto voids = [this](const std::function<void()>& halt) {
        arm();
        const std::uint16_t before = challenge;
        halt();
        challenge = before;
        const CommandVerdict late = send(DriveCommand{0.1}, robot.epoch());
        return late != CommandVerdict::Accepted;
    };
    EXPECT_TRUE(voids([this] { send(HaltCommand{}); }));
    EXPECT_TRUE(robot.armed()) << "a halt disarms nobody";
    EXPECT_TRUE(voids([this] { send(AbortAtemCommand{}); }));
    EXPECT_TRUE(voids([this] { send(ArmCommand{false}); }));
    EXPECT_TRUE(voids([this] { send(StopCommand{}); }));
    EXPECT_TRUE(voids([this] { robot.disarm(); }));
    EXPECT_TRUE(voids([this] {
        ASSERT_EQ(send(DriveCommand{0.1}), CommandVerdict::Accepted);
        now += 0.2;
        beat(1);
        now += 0.06;
        EXPECT_EQ(robot.tick(now), Silence::OfDrive);
    }));
}

TEST_F(RobotEnd, givesAChallengeOutOnceWithin54Minutes)
{
    beat(1);
    const std::uint16_t first = challenge;
    int heartbeatsBetween = 0;
    do {
        now += 0.01;
        beat(1);
        ASSERT_NE(challenge, 0);
        ++heartbeatsBetween;
    } while (challenge == first);
    EXPECT_GE(heartbeatsBetween, 5) << "heartbeats that come fast use none up";
    for (int i = 2; i < 65535; ++i) {
        now += 0.06;
        beat(1);
        ASSERT_NE(challenge, first) << i;
    }
    now += 0.06;
    beat(1);
    EXPECT_EQ(challenge, first);
    EXPECT_THROW(CommandReceiver(1, 0), std::invalid_argument);
}

TEST_F(RobotEnd, acceptsSafeCommandsInAnyEpochAndOrder)
{
    for (const Command& command : {Command{StopCommand{}}, Command{HaltCommand{}},
                                   Command{AbortAtemCommand{}}, Command{ArmCommand{false}}}) {
        const CanFrame frame = frameOf(command, 200, 5);
        for (int i = 0; i < 2; ++i) {
            const auto answer = robot.receive(frame, now);
            EXPECT_EQ(answer.verdict, CommandVerdict::Accepted) << command.index();
            ASSERT_TRUE(answer.command);
            EXPECT_EQ(answer.command->index(), command.index());
            EXPECT_EQ(answer.kind, kindOf(command));
            EXPECT_EQ(answer.counter, 5);
        }
    }
}

TEST_F(RobotEnd, stopsOnADamagedStop)
{
    arm();
    CanFrame frame = frameOf(StopCommand{}, 0, 0);
    frame.data.fill(0xFF);
    frame.length = 1;
    const auto answer = robot.receive(frame, now);
    ASSERT_TRUE(answer.command);
    EXPECT_TRUE(std::holds_alternative<StopCommand>(*answer.command));
    EXPECT_FALSE(robot.armed());
}

TEST_F(RobotEnd, releasesItsStopOnlyInThisEpoch)
{
    const std::uint8_t old = robot.epoch();
    send(StopCommand{});
    beat(1);
    EXPECT_EQ(send(ReleaseStopCommand{}, old), CommandVerdict::WrongEpoch);
    EXPECT_EQ(send(ReleaseStopCommand{}), CommandVerdict::Accepted);
    EXPECT_FALSE(robot.armed()) << "and does not arm by it";
}

TEST_F(RobotEnd, refusesEveryFrameOfARecordedSession)
{
    std::vector<CanFrame> recorded;
    arm();
    for (int i = 0; i < 500; ++i)  // 10 s of driving
        recorded.push_back(drive(static_cast<std::uint8_t>(i)));
    recorded.push_back(frameOf(ArmCommand{true}, robot.epoch(), 9, challenge));
    recorded.push_back(frameOf(ReleaseStopCommand{}, robot.epoch(), 9, challenge));
    recorded.push_back(frameOf(ProbeCommand{7}, robot.epoch(), 9, challenge));
    send(ArmCommand{false});
    arm();
    int accepted = 0;
    for (const CanFrame& frame : recorded)
        accepted += robot.receive(frame, now).verdict != CommandVerdict::WrongEpoch;
    EXPECT_EQ(accepted, 0);
}

TEST_F(RobotEnd, refusesFramesDelayedByAStalledBus)
{
    arm();
    std::vector<CanFrame> queued;
    for (int i = 0; i < 100; ++i) {  // 2 s at 50 Hz, and the heartbeats between
        queued.push_back(drive(static_cast<std::uint8_t>(i)));
        if (i % 5 == 0) queued.push_back(consoleHeartbeat(token, heartbeats++));
    }
    for (double end = now + 2.0; now < end; now += 0.05) robot.tick(now);
    EXPECT_FALSE(robot.armed());
    int obeyed = 0;
    for (const CanFrame& frame : queued) obeyed += robot.receive(frame, now).command.has_value();
    EXPECT_EQ(obeyed, 0);
}

TEST_F(RobotEnd, watchdogHaltsAndDisarmsWithoutHeartbeats)
{
    arm();
    const std::uint8_t epoch = robot.epoch();
    EXPECT_EQ(robot.tick(now + 0.249), Silence::None);
    EXPECT_EQ(robot.tick(now + 0.251), Silence::OfConsole);
    EXPECT_FALSE(robot.armed());
    EXPECT_NE(robot.epoch(), epoch);
    EXPECT_EQ(robot.tick(now + 0.3), Silence::None) << "said once";
}

TEST_F(RobotEnd, deadManHaltsWithoutDriveFrames)
{
    arm();
    ASSERT_EQ(send(DriveCommand{0.2}), CommandVerdict::Accepted);
    const double sent = now;
    now += 0.1;
    beat(2);
    EXPECT_EQ(robot.tick(sent + 0.249), Silence::None);
    EXPECT_EQ(robot.tick(sent + 0.251), Silence::OfDrive);
    EXPECT_EQ(robot.tick(sent + 0.252), Silence::None);
    EXPECT_TRUE(robot.armed());
    EXPECT_EQ(send(DriveCommand{0.2}), CommandVerdict::TooLate) << "it was sent before the end";
    beat(2);
    ASSERT_EQ(send(DriveCommand{0.2}), CommandVerdict::Accepted);
    ASSERT_EQ(send(HaltCommand{}), CommandVerdict::Accepted);
    beat(5);
    EXPECT_EQ(robot.tick(now), Silence::None) << "a halt ends the drive";
}

TEST_F(RobotEnd, recognisesFramesThatAreNoCommands)
{
    EXPECT_EQ(robot.receive({.id = 0x123, .length = 8}, now).verdict, CommandVerdict::NotACommand);
    EXPECT_EQ(robot.receive(frameOf(RobotStatus{}, 0), now).verdict, CommandVerdict::NotACommand);
    CanFrame frame = frameOf(HaltCommand{}, 0, 0);
    frame.extended = true;
    EXPECT_EQ(robot.receive(frame, now).verdict, CommandVerdict::NotACommand);
    frame.extended = false;
    frame.length = 7;
    EXPECT_EQ(robot.receive(frame, now).verdict, CommandVerdict::Malformed);
    EXPECT_THROW(robot.receive(consoleHeartbeat(1, 1), std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
