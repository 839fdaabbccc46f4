// Tests which frames of the robot's protocol may be used.
#include "core/wire/frame_validator.h"

#include <gtest/gtest.h>

#include <span>

#include "core/limits.h"
#include "core/wire/telemetry.h"

namespace terratact {
namespace {

CanFrame attitude(int counter)
{
    return pack({.kind = FrameKind::Attitude,
                 .counter = static_cast<std::uint8_t>(counter),
                 .values = {0.21, -0.05, 1.0}});
}

TEST(FrameValidator, aFrameInSequenceIsSound)
{
    FrameValidator validator;
    for (int i = 1; i <= 3; ++i) {
        const JudgedFrame judged = validator.judge(attitude(i), 0.05 * i);
        EXPECT_EQ(judged.trouble, FrameTrouble::None) << i;
        EXPECT_TRUE(judged.isSound());
        EXPECT_EQ(judged.kind, FrameKind::Attitude);
        EXPECT_NEAR(judged.content.values[0], 0.21, 1e-4);
        EXPECT_EQ(judged.silence.has_value(), i > 1) << "the first follows no other";
    }
}

TEST(FrameValidator, lostFramesLeaveTheNextUsable)
{
    FrameValidator validator;
    (void)validator.judge(attitude(1), 0.0);
    const JudgedFrame judged = validator.judge(attitude(3), 0.1);
    EXPECT_EQ(judged.trouble, FrameTrouble::Gap);
    EXPECT_TRUE(judged.isSound());
}

TEST(FrameValidator, aLongSilenceIsAGapThoughNoneIsMissing)
{
    FrameValidator validator;
    (void)validator.judge(attitude(1), 0.0);
    EXPECT_EQ(validator.judge(attitude(2), kLinkLostAfter - 0.01).trouble, FrameTrouble::None);
    const double late = 2.0 * kLinkLostAfter;
    const JudgedFrame judged = validator.judge(attitude(3), late);
    EXPECT_EQ(judged.trouble, FrameTrouble::Gap);
    EXPECT_NEAR(judged.silence.value(), kLinkLostAfter + 0.01, 1e-9);
}

TEST(FrameValidator, aRepeatedOrReplayedFrameIsNotUsed)
{
    FrameValidator validator;
    (void)validator.judge(attitude(1), 0.0);
    for (const int counter : {1, 9}) {
        const JudgedFrame judged = validator.judge(attitude(counter), 0.05);
        EXPECT_EQ(judged.trouble, FrameTrouble::WrongSequence) << counter;
        EXPECT_FALSE(judged.isSound());
    }
}

TEST(FrameValidator, aFlippedBitIsAWrongChecksum)
{
    for (int bit = 0; bit < 64; ++bit) {
        FrameValidator validator;
        CanFrame frame = attitude(1);
        frame.data[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        const JudgedFrame judged = validator.judge(frame, 0.0);
        EXPECT_EQ(judged.trouble, FrameTrouble::WrongChecksum) << bit;
        EXPECT_EQ(judged.kind, FrameKind::Attitude);
        EXPECT_FALSE(judged.isSound());
    }
}

TEST(FrameValidator, framesOfOtherDevicesAreUnknown)
{
    FrameValidator validator;
    CanFrame extended = attitude(1);
    extended.extended = true;
    for (const CanFrame& frame : {CanFrame{.id = 0x5AB, .length = 8}, extended}) {
        const JudgedFrame judged = validator.judge(frame, 0.0);
        EXPECT_EQ(judged.trouble, FrameTrouble::Unknown);
        EXPECT_FALSE(judged.kind);
    }
    EXPECT_EQ(validator.judge({.id = 0x4, .error = true, .length = 8}, 0.0).trouble,
              FrameTrouble::Other);
}

TEST(FrameValidator, eachKindHasItsOwnCounter)
{
    FrameValidator validator;
    (void)validator.judge(attitude(1), 0.0);
    const CanFrame odometry = pack({.kind = FrameKind::Odometry, .counter = 7});
    EXPECT_EQ(validator.judge(odometry, 0.01).trouble, FrameTrouble::None);
    EXPECT_EQ(validator.judge(attitude(2), 0.05).trouble, FrameTrouble::None);
}

struct Validating : testing::Test {
    FrameValidator validator;
    double now = 10.0;
    std::uint8_t counter = 0;

    CanFrame status() { return frameOf(RobotStatus{.epoch = 7}, ++counter); }
    JudgedFrame judge(const CanFrame& frame) { return validator.judge(frame, now += 0.05); }
};

TEST_F(Validating, statusThatNoRobotSendsCountsAsMissing)
{
    judge(status());
    CanFrame frame = status();
    frame.data[3] = 0;  // epoch 0
    protect(std::span(frame.data).first(8), counter, layoutOf(FrameKind::RobotStatus).dataId);
    const JudgedFrame judged = judge(frame);
    EXPECT_EQ(judged.fault, FrameFault::OutOfRange);
    EXPECT_EQ(judged.trouble, FrameTrouble::Other);
    EXPECT_NEAR(validator.age(FrameKind::RobotStatus, now).value(), 0.05, 1e-9);
    EXPECT_EQ(judge(status()).check, FrameCheck::SomeLost);
}

TEST_F(Validating, damagedFramesEndAGoodLink)
{
    for (int i = 0; i < E2eReceiver::kWindow; ++i) judge(status());
    EXPECT_EQ(validator.link(FrameKind::RobotStatus, now), LinkState::Good);
    for (int i = 0; i < E2eReceiver::kErrors; ++i) {
        CanFrame frame = status();
        frame.data[5] ^= 1U;
        EXPECT_EQ(judge(frame).trouble, FrameTrouble::WrongChecksum);
    }
    EXPECT_EQ(validator.link(FrameKind::RobotStatus, now), LinkState::Bad);
}

TEST_F(Validating, errorFrameHasNoKind)
{
    CanFrame frame = status();
    frame.error = true;
    const JudgedFrame judged = judge(frame);
    EXPECT_EQ(judged.trouble, FrameTrouble::Other);
    EXPECT_FALSE(judged.kind);
    EXPECT_EQ(validator.link(FrameKind::RobotStatus, now), LinkState::Unknown);
}

}  // namespace
}  // namespace terratact
