// Limits of the command gate to the bit, heartbeats, and frames that are no commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "core/atem/command_gate.h"
#include "tests/core/atem/gate_views.h"

namespace terratact {
namespace {

struct Limited {
    std::function<Command(double)> command;
    GateView view;
    double limit, step;  ///< both positive; step: one raw number
    std::function<void(GateLimits&, double)> set;
    double sign = 1.0;
};

TEST(Gate, keepsEveryValueWithinItsLimitToOneRawStep)
{
    const std::vector<Limited> all{
        {[](double v) { return DriveCommand{v}; }, ready(), 0.3, 1e-4,
         [](GateLimits& l, double v) { l.speed = v; }},
        {[](double v) { return DriveCommand{v}; }, ready(), 0.3, 1e-4,
         [](GateLimits& l, double v) { l.speed = v; }, -1.0},
        {[](double v) { return PressCommand{v}; }, ready(RobotActivity::Halted, true), 20.0, 0.01,
         [](GateLimits& l, double v) { l.torque = v; }},
        {[](double v) { return AdvanceCommand{v}; }, ready(), 0.05, 1e-4,
         [](GateLimits& l, double v) { l.advance = v; }},
        {[](double v) {
             return HoldFlippersCommand{v, 0.0};
         },
         ready(), 1.0, 2e-3, [](GateLimits& l, double v) { l.highestFlipper = v; }},
        {[](double v) {
             return HoldFlippersCommand{0.0, v};
         },
         ready(), 1.0, 2e-3, [](GateLimits& l, double v) { l.highestFlipper = v; }},
        {[](double v) {
             return HoldFlippersCommand{v, 0.0};
         },
         ready(), 0.5, 2e-3, [](GateLimits& l, double v) { l.lowestFlipper = -v; }, -1.0},
        {[](double v) {
             return HoldFlippersCommand{0.0, v};
         },
         ready(), 0.5, 2e-3, [](GateLimits& l, double v) { l.lowestFlipper = -v; }, -1.0},
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Limited& c = all[i];
        GateLimits limits;
        c.set(limits, c.limit);
        EXPECT_EQ(verdict(c.command(c.sign * c.limit), c.view, limits), None) << i;
        EXPECT_EQ(verdict(c.command(c.sign * (c.limit + c.step)), c.view, limits), OverLimit) << i;
        c.set(limits, kNan);
        EXPECT_EQ(verdict(c.command(c.sign * c.limit), c.view, limits), OverLimit) << i;
    }
}

TEST(Gate, defaultLimitsCoverExactlyTheDbcRanges)
{
    EXPECT_EQ(verdict(DriveCommand{0.6}, ready()), None);
    EXPECT_EQ(verdict(DriveCommand{-0.6}, ready()), None);
    EXPECT_EQ(verdict(AdvanceCommand{0.1}, ready()), None);
    EXPECT_EQ(verdict(PressCommand{60.0}, ready(RobotActivity::Pressed, true)), None);
    EXPECT_EQ(verdict(AdvanceCommand{0.001}, ready()), None);
    EXPECT_EQ(verdict(PressCommand{0.01}, ready(RobotActivity::Pressed, true)), None);
    EXPECT_EQ(verdict(HoldFlippersCommand{3.14, -1.6}, ready()), None);
    EXPECT_EQ(verdict(HoldFlippersCommand{-1.602, 0.0}, ready()), OverLimit);
    // The codec refuses 0.1001 m, so this frame is built by hand.
    CanFrame frame = frameOf(AdvanceCommand{0.1}, kEpoch, 1, kChallenge);
    frame.data[4] = 1001 & 0xFF;
    frame.data[5] = 1001 >> 8;
    protect(std::span(frame.data).first(8), 1, layoutOf(FrameKind::Advance).dataId);
    GateLimits wide;
    wide.advance = 100.0;
    EXPECT_EQ(judge(frame, ready(), wide), Malformed);
}

TEST(Gate, sweepsEveryRawSpeed)
{
    GateLimits limits;
    limits.speed = 0.2;
    int passed = 0;
    for (int raw = -32768; raw <= 32767; ++raw) {
        CanFrame frame = frameOf(DriveCommand{0.0}, kEpoch, 1, kChallenge);
        frame.data[4] = static_cast<std::uint8_t>(raw & 0xFF);
        frame.data[5] = static_cast<std::uint8_t>((raw >> 8) & 0xFF);
        protect(std::span(frame.data).first(8), 1, layoutOf(FrameKind::Drive).dataId);
        const GateRefusal refusal = judge(frame, ready(), limits);
        const int size = std::abs(raw);
        ASSERT_EQ(refusal, size <= 2000 ? None : size <= 6000 ? OverLimit : Malformed) << raw;
        passed += refusal == None;
    }
    EXPECT_EQ(passed, 4001);
}

TEST(Gate, heartbeatNeedsOnlyTheOperator)
{
    GateView view;
    const CanFrame heartbeat = consoleHeartbeat(4711, 1);
    view.operatorAge = kLimits.operatorAge;
    EXPECT_EQ(judge(heartbeat, view, kLimits), None);
    view.operatorAge = kLimits.operatorAge + 1e-6;
    EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
}

TEST(Gate, heartbeatsMayPauseASecondWhileNothingMoves)
{
    const CanFrame heartbeat = consoleHeartbeat(4711, 1);
    GateView view;
    view.moves = false;
    view.operatorAge = kLimits.operatorPause;
    EXPECT_EQ(judge(heartbeat, view, kLimits), None);
    view.operatorAge = kLimits.operatorPause + 1e-6;
    EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
    for (const double bad : {kNan, -0.001}) {
        view.operatorAge = bad;
        EXPECT_EQ(judge(heartbeat, view, kLimits), OperatorAbsent);
    }
    // Only the heartbeat passes: motion needs a recent answer.
    for (const Case& c : conditional()) {
        GateView paused = approved();
        paused.moves = false;
        paused.operatorAge = 0.3;
        EXPECT_EQ(verdict(c.command, paused), OperatorAbsent);
    }
}

TEST(Gate, neverSendsAFrameOfTheRobot)
{
    for (const CanFrame& frame : {frameOf(RobotStatus{}, 0), robotHeartbeat(1, 0)})
        EXPECT_EQ(judge(frame, approved(), kLimits), NotAllowed);
    for (const CanFrame& frame : framesOf(SensorLine{}, 0))
        EXPECT_EQ(judge(frame, approved(), kLimits), NotAllowed);
}

/// Every state of arming, robot and operator, some hundreds of views.
std::vector<GateView> manyViews()
{
    std::vector<GateView> views{GateView{}};
    for (const auto phase : {ArmingPhase::Disarmed, ArmingPhase::Confirming, ArmingPhase::Requested,
                             ArmingPhase::Armed})
        for (int activity = 0; activity <= static_cast<int>(RobotActivity::Stopped); ++activity)
            for (const bool exploring : {false, true})
                for (const bool stop : {false, true}) {
                    GateView view = ready(static_cast<RobotActivity>(activity), exploring);
                    view.arming.phase = phase;
                    view.stopLatched = stop;
                    view.approval = ProbeApproval{8, 1.0};
                    views.push_back(view);
                }
    return views;
}

TEST(Gate, leaksNoFrameOfAnyIdLengthFlagAndState)
{
    std::uint64_t leaks = 0;
    // Frames that are valid except for identifier, length or flags.
    const CanFrame sound = frameOf(StopCommand{}, 0, 1);
    for (const GateView& view : manyViews())
        for (std::uint32_t id = 0; id < 2048; ++id)
            for (std::uint8_t length = 0; length <= 8; ++length) {
                if (id == sound.id && length == 8) continue;
                CanFrame frame = sound;
                frame.id = id;
                frame.length = length;
                leaks += judge(frame, view, kLimits) == None;
            }
    EXPECT_EQ(leaks, 0U);
}

TEST(Gate, leaksNoFlaggedFrameAndNoExtendedIdentifier)
{
    std::mt19937 rng(3);
    std::uint64_t leaks = 0;
    std::vector<CanFrame> frames;
    for (const Case& c : conditional()) frames.push_back(frameOf(c.command, kEpoch, 1, kChallenge));
    for (const Command& c : safeCommands()) frames.push_back(frameOf(c, kEpoch, 1));
    for (const CanFrame& frame : frames)
        for (unsigned flags = 1; flags < 16; ++flags) {
            CanFrame flagged = frame;
            flagged.extended = (flags & 1U) != 0;
            flagged.remote = (flags & 2U) != 0;
            flagged.error = (flags & 4U) != 0;
            flagged.fd = (flags & 8U) != 0;
            for (const GateView& view : manyViews()) leaks += judge(flagged, view, kLimits) == None;
        }
    for (int i = 0; i < 1'000'000; ++i) {
        CanFrame frame = frames[static_cast<std::size_t>(i) % frames.size()];
        frame.id = static_cast<std::uint32_t>(rng()) & 0x1FFFFFFFU;
        frame.extended = true;
        leaks += judge(frame, ready(), kLimits) == None;
    }
    EXPECT_EQ(leaks, 0U);
}

TEST(Gate, distinguishesDamagedFromForeignFrames)
{
    CanFrame frame = frameOf(StopCommand{}, 0, 1);
    frame.data[7] ^= 1U;
    EXPECT_EQ(judge(frame, ready(), kLimits), Malformed);
    frame.length = 7;
    EXPECT_EQ(judge(frame, ready(), kLimits), Malformed);
    frame.remote = true;
    EXPECT_EQ(judge(frame, ready(), kLimits), NotAllowed);
    EXPECT_EQ(judge({.id = 0x123, .length = 8}, ready(), kLimits), NotAllowed);
}

TEST(Gate, hasWordsForEveryRefusal)
{
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(OtherBin); ++i)
        words.insert(describe(static_cast<GateRefusal>(i)).english);
    EXPECT_EQ(words.size(), static_cast<std::size_t>(OtherBin) + 1);
    EXPECT_FALSE(words.contains(""));
    EXPECT_THROW(static_cast<void>(describe(static_cast<GateRefusal>(99)).english),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
