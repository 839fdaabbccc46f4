#include "core/wire/frame_validator.h"

#include <gtest/gtest.h>

#include <span>

#include "core/wire/telemetry.h"

namespace terratact {
namespace {

struct Validating : testing::Test {
    FrameValidator validator;
    double now = 10.0;
    std::uint8_t counter = 0;

    CanFrame status() { return frameOf(RobotStatus{.epoch = 7}, ++counter); }
    JudgedFrame judge(const CanFrame& frame) { return validator.judge(frame, now += 0.05); }
};

TEST_F(Validating, frameInOrderIsSound)
{
    const JudgedFrame judged = judge(status());
    EXPECT_TRUE(judged.isSound());
    EXPECT_EQ(judged.kind, FrameKind::RobotStatus);
    EXPECT_FALSE(judged.fault);
    EXPECT_FALSE(judged.silence);
    EXPECT_NEAR(judge(status()).silence.value(), 0.05, 1e-9);
}

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
