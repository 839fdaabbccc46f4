#include "core/wire/e2e.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/wire/freshness.h"

namespace terratact {
namespace {

using Payload = std::vector<std::uint8_t>;

constexpr std::uint16_t kId = 0x1234;

Payload frame(int counter, std::uint16_t id = kId)
{
    Payload bytes(8);
    protect(bytes, static_cast<std::uint8_t>(counter), id);
    return bytes;
}

TEST(Crc16, agreesWithThePublishedVectors)
{
    const Payload digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(crc16(digits), 0x29B1);
    EXPECT_EQ(crc16(Payload{0x00, 0x00, 0x00, 0x00}), 0x84C0);
    EXPECT_EQ(crc16(Payload{0xF2, 0x01, 0x83}), 0xD374);
    EXPECT_EQ(crc16(Payload{0xFF, 0xFF, 0xFF, 0xFF}), 0x1D0F);
}

TEST(Protection, agreesWithTheVectorsOfProfileFive)
{
    EXPECT_EQ(frame(0), (Payload{0x1C, 0xCA, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(frame(1), (Payload{0xCF, 0x8D, 1, 0, 0, 0, 0, 0}));
}

TEST(Protection, needsRoomForItsHeader)
{
    Payload two(2);
    EXPECT_THROW(protect(two, 0, kId), std::invalid_argument);
    EXPECT_FALSE(isIntact(two, kId));
    EXPECT_FALSE(isIntact({}, kId));
}

// The checksum is linear: the detection of a pattern of flips does not depend on the content.
class FlippedBits : public testing::TestWithParam<int> {};

TEST_P(FlippedBits, oneTwoOrThreeAreAlwaysCaught)
{
    Payload bytes(static_cast<std::size_t>(GetParam()));
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(37 * i);
    protect(bytes, 200, kId);
    ASSERT_TRUE(isIntact(bytes, kId));
    const int bits = 8 * GetParam();
    const auto flip = [&](int bit) {
        bytes[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1 << bit % 8);
    };
    for (int a = 0; a < bits; ++a) {
        flip(a);
        ASSERT_FALSE(isIntact(bytes, kId)) << a;
        for (int b = a + 1; b < bits; ++b) {
            flip(b);
            ASSERT_FALSE(isIntact(bytes, kId)) << a << " " << b;
            for (int c = b + 1; c < bits; ++c) {
                flip(c);
                ASSERT_FALSE(isIntact(bytes, kId)) << a << " " << b << " " << c;
                flip(c);
            }
            flip(b);
        }
        flip(a);
    }
    EXPECT_TRUE(isIntact(bytes, kId));
}

INSTANTIATE_TEST_SUITE_P(ofEveryLength, FlippedBits, testing::Range(3, 9));

TEST(Protection, detectsEveryOtherDataId)
{
    const Payload bytes = frame(7);
    for (int id = 0; id <= 0xFFFF; ++id)
        ASSERT_EQ(isIntact(bytes, static_cast<std::uint16_t>(id)), id == kId) << id;
}

struct Link : testing::Test {
    FrameCheck receive(int counter) { return receiver.receive(frame(counter % 256), now); }
    void receiveGood(int frames)
    {
        for (int i = 0; i < frames; ++i, now += 0.05) receive(++last);
        now -= 0.05;
    }
    /// Expects Good after nine more frames; the first frame of the window has come.
    void expectGoodAfterNineMore()
    {
        now += 0.05;
        receiveGood(8);
        EXPECT_EQ(receiver.state(now), LinkState::Starting);
        now += 0.05;
        receiveGood(1);
        EXPECT_EQ(receiver.state(now), LinkState::Good);
    }
    E2eReceiver receiver{kId};
    double now = 100.0;
    int last = 0;
};

TEST_F(Link, isGoodAfterAWindowOfGoodFramesAndNotBefore)
{
    EXPECT_EQ(receiver.state(now), LinkState::Unknown);
    EXPECT_FALSE(receiver.age(now));
    receiveGood(1);
    EXPECT_EQ(receiver.state(now), LinkState::Starting);
    expectGoodAfterNineMore();
}

TEST_F(Link, judgesEveryStepOfTheCounter)
{
    for (int before = 0; before < 256; ++before) {
        for (int delta = 0; delta < 256; ++delta) {
            E2eReceiver fresh(kId);
            ASSERT_EQ(fresh.receive(frame(before), 0.0), FrameCheck::Ok);
            const FrameCheck expected = delta == 0 ? FrameCheck::Repeated
                                      : delta == 1 ? FrameCheck::Ok
                                      : delta <= 3 ? FrameCheck::SomeLost
                                                   : FrameCheck::WrongSequence;
            ASSERT_EQ(fresh.receive(frame((before + delta) % 256), 0.05), expected)
                << before << " " << delta;
        }
    }
}

TEST_F(Link, livesThroughOneErrorInTheWindowAndEndsWithTwo)
{
    receiveGood(10);
    Payload damaged = frame(last + 1);
    damaged[5] ^= 1U;
    EXPECT_EQ(receiver.receive(damaged, now), FrameCheck::WrongCrc);
    EXPECT_EQ(receiver.state(now), LinkState::Good);
    EXPECT_EQ(receiver.receive(damaged, now), FrameCheck::WrongCrc);
    EXPECT_EQ(receiver.state(now), LinkState::Bad);
    ++last;  // the damaged one
    receiveGood(9);
    EXPECT_EQ(receiver.state(now), LinkState::Bad);
    receiveGood(1);
    EXPECT_EQ(receiver.state(now), LinkState::Good) << "a whole window without error";
}

TEST_F(Link, forgetsAnErrorThatHasLeftTheWindow)
{
    receiveGood(10);
    Payload damaged = frame(0);
    damaged[0] ^= 1U;
    for (int i = 0; i < 5; ++i) {
        receiver.receive(damaged, now);
        EXPECT_EQ(receiver.state(now), LinkState::Good);
        receiveGood(9);
        EXPECT_EQ(receiver.state(now), LinkState::Good);
        receiveGood(1);
    }
}

TEST_F(Link, countsAnotherSendersFrameAsDamaged)
{
    EXPECT_EQ(receiver.receive(frame(1, kId + 1), now), FrameCheck::WrongCrc);
    EXPECT_EQ(receiver.receive(Payload(2), now), FrameCheck::WrongCrc);
}

TEST_F(Link, isStaleAndThenLostWithoutFrames)
{
    receiveGood(10);
    EXPECT_EQ(receiver.state(now + 0.1499), LinkState::Good);
    EXPECT_EQ(receiver.state(now + 0.1501), LinkState::Stale);
    EXPECT_EQ(receiver.state(now + 0.2499), LinkState::Stale);
    EXPECT_EQ(receiver.state(now + 0.2501), LinkState::Lost);
    EXPECT_NEAR(*receiver.age(now + 0.2), 0.2, 1e-9);
}

TEST_F(Link, isNotKeptAliveByDamagedOrRepeatedFrames)
{
    receiveGood(10);
    const double end = now + 0.3;
    for (; now < end; now += 0.01) receive(last);
    EXPECT_EQ(receiver.state(now), LinkState::Lost);
}

TEST_F(Link, restartsAfterAnOutageOfOneCounterTurn)
{
    receiveGood(10);
    now += 256 * 0.05;
    EXPECT_EQ(receive(last + 256), FrameCheck::Repeated) << "might be the old one";
    EXPECT_EQ(receiver.state(now), LinkState::Lost);
    now += 0.05;
    EXPECT_EQ(receive(last + 257), FrameCheck::Ok);
    EXPECT_EQ(receiver.state(now), LinkState::Starting);
    last += 257;
    now += 0.05;
    receiveGood(9);
    EXPECT_EQ(receiver.state(now), LinkState::Good);
}

TEST_F(Link, needsAWholeWindowAgainAfterItWasLost)
{
    receiveGood(10);
    now += 0.3;
    last += 100;
    EXPECT_EQ(receive(++last), FrameCheck::Ok) << "a sender that has begun anew is no error";
    expectGoodAfterNineMore();
}

TEST_F(Link, acceptsAgesEqualToItsLimits)
{
    receiver = E2eReceiver(kId, {.stale = 0.125, .lost = 0.25});
    now = 0.0;
    for (int i = 0; i < 10; ++i) receive(++last);
    EXPECT_EQ(receiver.state(0.125), LinkState::Good);
    EXPECT_EQ(receiver.state(0.25), LinkState::Stale);
    EXPECT_NO_THROW(E2eReceiver(kId, {.stale = 0.25, .lost = 0.25}));
}

TEST_F(Link, isLostWhenTimeRunsBackwards)
{
    receiveGood(10);
    EXPECT_EQ(receiver.state(now - 1.0), LinkState::Lost);
}

TEST_F(Link, refusesInvalidTimesAndLimits)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(receiver.receive(frame(1), nan), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(receiver.state(INFINITY)), std::invalid_argument);
    EXPECT_THROW(E2eReceiver(kId, {.stale = 0.0, .lost = 1.0}), std::invalid_argument);
    EXPECT_THROW(E2eReceiver(kId, {.stale = 0.2, .lost = 0.1}), std::invalid_argument);
    EXPECT_THROW(E2eReceiver(kId, {.stale = nan, .lost = 0.1}), std::invalid_argument);
    EXPECT_THROW(E2eReceiver(kId, {.stale = 0.2, .lost = INFINITY}), std::invalid_argument);
}

TEST(Freshness, isTheAgeOfTheNewestQuestionThatWasAnswered)
{
    Freshness freshness;
    EXPECT_FALSE(freshness.age(1.0));
    freshness.sent(11, 1.0);
    freshness.sent(12, 1.1);
    EXPECT_FALSE(freshness.age(1.1));
    EXPECT_TRUE(freshness.echoed(12));
    EXPECT_NEAR(*freshness.age(1.2), 0.1, 1e-12);
    EXPECT_TRUE(freshness.echoed(11)) << "late, but an answer";
    EXPECT_NEAR(*freshness.age(1.2), 0.1, 1e-12) << "and makes nothing older";
}

TEST(Freshness, isNotRenewedByARecording)
{
    Freshness freshness;
    EXPECT_FALSE(freshness.echoed(0)) << "nothing was asked yet";
    for (int i = 0; i < 5; ++i) freshness.sent(static_cast<std::uint16_t>(10 + i), i);
    EXPECT_FALSE(freshness.echoed(10)) << "five heartbeats ago";
    EXPECT_FALSE(freshness.echoed(99));
    EXPECT_FALSE(freshness.age(5.0));
    EXPECT_TRUE(freshness.echoed(11));
    EXPECT_THROW(freshness.sent(1, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
