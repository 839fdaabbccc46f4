#include "core/wire/telemetry_listener.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kPeriod = 0.05;  // [s]

Measurement measured()
{
    return {.pitch = 0.21,
            .frontLeft = -0.3,
            .frontRight = -0.3,
            .force = {0, 1, 2, 3, 4, 5},
            .arm = {}};
}

struct Listening : testing::Test {
    const RobotModel robot = absolem();
    TelemetryListener listener{robot};
    double now = 100.0;
    std::uint8_t counter = 250;  // so that it wraps on the way
    RobotStatus status{.epoch = 7, .activity = RobotActivity::Pressed, .refusal = Refusal::Busy};

    std::optional<Measurement> receiveLine(const SensorLine& line)
    {
        std::optional<Measurement> got;
        for (const CanFrame& frame : framesOf(line, counter)) {
            const auto m = listener.receive(frame, now);
            if (m) {
                EXPECT_FALSE(got) << "two measurements of one line";
                got = m;
            }
        }
        return got;
    }
    std::optional<Measurement> receiveLine()
    {
        return receiveLine(sensorLineOf(measured(), robot));
    }
    void receiveStatus() { listener.receive(frameOf(status, counter), now); }

    /// Sends what a robot sends every 50 ms.
    std::optional<Measurement> tick()
    {
        ++counter;
        now += kPeriod;
        receiveStatus();
        return receiveLine();
    }
    LinkState link() const { return listener.link(FrameKind::RobotStatus, now); }
};

TEST_F(Listening, makesAMeasurementOfEveryLine)
{
    for (int i = 0; i < 20; ++i) {
        const auto m = tick();
        ASSERT_TRUE(m) << i;
        EXPECT_EQ(m->time, now);
        EXPECT_NEAR(m->pitch, 0.21, 1e-4);
        EXPECT_NEAR(m->force[5], 5.0, 0.05);
        EXPECT_EQ(m->activity, RobotActivity::Pressed);
        EXPECT_EQ(m->refusal, Refusal::Busy);
    }
    EXPECT_EQ(listener.counters(), (TelemetryCounters{.used = 240, .lines = 20}));
    EXPECT_EQ(link(), LinkState::Good);
    EXPECT_EQ(listener.link(FrameKind::Attitude, now), LinkState::Good);
    EXPECT_EQ(listener.status(), status);
    EXPECT_EQ(listener.age(FrameKind::RobotStatus, now + 0.04).value(), now + 0.04 - now);
    EXPECT_EQ(listener.link(FrameKind::RobotStatus, now + 0.2), LinkState::Stale);
    EXPECT_EQ(listener.link(FrameKind::RobotStatus, now + 0.3), LinkState::Lost);
}

TEST_F(Listening, hasNoStateAtFirst)
{
    EXPECT_EQ(link(), LinkState::Unknown);
    EXPECT_FALSE(listener.age(FrameKind::RobotStatus, now));
    EXPECT_FALSE(listener.status());
    EXPECT_FALSE(listener.token());
    EXPECT_EQ(listener.forces(), ElementForces{});
    EXPECT_EQ(listener.counters(), TelemetryCounters{});
}

TEST_F(Listening, makesNoMeasurementWithoutAStatusBesideTheLine)
{
    EXPECT_FALSE(receiveLine());
    EXPECT_EQ(listener.counters().orphans, 1U);
    ASSERT_TRUE(tick());
    now += 0.24;
    ++counter;
    EXPECT_TRUE(receiveLine()) << "the status is 0.24 s old";
    now += 0.02;
    ++counter;
    EXPECT_FALSE(receiveLine()) << "the status is over 0.25 s old";
    EXPECT_EQ(listener.counters().orphans, 2U);
    EXPECT_EQ(listener.status(), status) << "the last one is kept";
    EXPECT_TRUE(tick());
}

TEST_F(Listening, refusesARepeatedLineAndAnOldOne)
{
    ASSERT_TRUE(tick());
    const std::uint8_t before = counter;
    ASSERT_TRUE(tick());
    EXPECT_FALSE(receiveLine());
    EXPECT_EQ(listener.counters().repeated, 11U);
    counter = before;
    EXPECT_FALSE(receiveLine());
    EXPECT_EQ(listener.counters().wrongSequence, 11U);
    EXPECT_EQ(listener.counters().lines, 2U);
}

TEST_F(Listening, countsMissingFramesAndLines)
{
    ASSERT_TRUE(tick());
    counter = static_cast<std::uint8_t>(counter + 2);
    ASSERT_TRUE(tick()) << "two lines are missing";
    EXPECT_EQ(listener.counters().gaps, 12U);
    ++counter;
    const auto frames = framesOf(sensorLineOf(measured(), robot), counter);
    for (std::size_t i = 0; i + 1 < frames.size(); ++i)
        EXPECT_FALSE(listener.receive(frames[i], now));
    ASSERT_TRUE(tick());
    EXPECT_EQ(listener.counters().unfinished, 1U);
}

TEST_F(Listening, countsLinesInWhichSomethingWasNotMeasured)
{
    ASSERT_TRUE(tick());
    SensorLine line = sensorLineOf(measured(), robot);
    line.attitude.reset();
    (*line.voltages[0])[1] = 0.0;
    ++counter;
    receiveStatus();
    EXPECT_FALSE(receiveLine(line));
    EXPECT_EQ(listener.counters().partial, 1U);
    EXPECT_TRUE(listener.forces().carried);
    EXPECT_EQ(listener.forces().left[1]->state, ElementState::Open);
    EXPECT_EQ(listener.forces().right[1]->state, ElementState::Sound);
}

TEST_F(Listening, countsEachFaultAndDamagesTheLink)
{
    for (int i = 0; i < 10; ++i) tick();
    ASSERT_EQ(link(), LinkState::Good);
    const CanFrame sound = frameOf(status, static_cast<std::uint8_t>(counter + 1));
    const std::uint64_t used = listener.counters().used;

    CanFrame extended = sound, unknown = sound;
    extended.extended = true;
    unknown.id = 0x7FF;
    listener.receive(extended, now);
    listener.receive(unknown, now);
    EXPECT_EQ(listener.counters().of(FrameFault::NotClassicData), 1U);
    EXPECT_EQ(listener.counters().of(FrameFault::UnknownId), 1U);
    EXPECT_EQ(link(), LinkState::Good) << "somebody else's frames are no fault of this link";

    CanFrame damaged = sound;
    damaged.data[4] ^= 0x01U;
    listener.receive(damaged, now);
    EXPECT_EQ(link(), LinkState::Good) << "one error in the window";
    CanFrame shortOne = sound;
    shortOne.length = 7;
    listener.receive(shortOne, now);
    EXPECT_EQ(listener.counters().of(FrameFault::WrongCrc), 1U);
    EXPECT_EQ(listener.counters().of(FrameFault::WrongLength), 1U);
    EXPECT_EQ(link(), LinkState::Bad);
    EXPECT_EQ(listener.counters().used, used);
}

TEST_F(Listening, shortFramesDoNotKeepALinkAlive)
{
    for (int i = 0; i < 10; ++i) tick();
    CanFrame frame = frameOf(status, ++counter);
    frame.length = 7;
    const FrameLayout& layout = layoutOf(FrameKind::RobotStatus);
    protect(std::span(frame.data).first(7), counter, layout.dataId);
    now += 0.1;
    listener.receive(frame, now);
    EXPECT_NEAR(*listener.age(FrameKind::RobotStatus, now), 0.1, 1e-9);
}

TEST_F(Listening, takesAValueOutOfRangeForAMissingFrame)
{
    for (int i = 0; i < 10; ++i) tick();
    const FrameLayout& layout = layoutOf(FrameKind::RobotStatus);
    for (const int byte : {3, 6}) {  // an epoch of 0; a last command that no console sends
        CanFrame frame = frameOf(status, ++counter);
        frame.data[static_cast<std::size_t>(byte)] = byte == 3 ? 0 : 5;
        protect(std::span(frame.data).first(8), counter, layout.dataId);
        now += 0.1;
        listener.receive(frame, now);
    }
    EXPECT_EQ(listener.counters().of(FrameFault::OutOfRange), 2U);
    EXPECT_EQ(listener.status()->epoch, 7);
    EXPECT_EQ(link(), LinkState::Stale);
}

TEST_F(Listening, countsAConsolesFramesAndKeepsTheTokenOfAnAnswer)
{
    listener.receive(consoleHeartbeat(0x1234, 1), now);
    listener.receive(frameOf(Command{StopCommand{}}, 7, 1), now);
    EXPECT_EQ(listener.counters().fromConsole, 2U);
    EXPECT_FALSE(listener.token());
    listener.receive(robotHeartbeat(0x1234, 1), now);
    EXPECT_EQ(listener.token(), 0x1234);
    EXPECT_EQ(listener.counters().used, 1U);
    EXPECT_THROW(static_cast<void>(listener.link(FrameKind::Stop, now)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(listener.age(FrameKind::ConsoleHeartbeat, now)),
                 std::invalid_argument);
}

TEST_F(Listening, refusesATimeThatIsNotFinite)
{
    EXPECT_THROW(listener.receive(CanFrame{}, std::nan("")), std::invalid_argument);
    EXPECT_THROW(listener.receive(CanFrame{}, std::numeric_limits<double>::infinity()),
                 std::invalid_argument);
}

TEST_F(Listening, putsEveryFrameOfAnyKindIntoOneCounter)
{
    std::mt19937 random(5);
    std::uint64_t taken = 0;
    for (int i = 0; i < 20'000; ++i) {
        auto frames = framesOf(sensorLineOf(measured(), robot), ++counter);
        CanFrame frame = frames[random() % frames.size()];
        if (random() % 4 == 0) frame = frameOf(status, counter);
        for (auto n = random() % 3; n > 0; --n)
            frame.data[random() % 8] ^= static_cast<std::uint8_t>(1U << (random() % 8));
        if (random() % 8 == 0) frame.length = static_cast<std::uint8_t>(random() % 65);
        if (random() % 8 == 0) frame.id = static_cast<std::uint32_t>(random() % 64);
        frame.fd = random() % 16 == 0;
        frame.remote = random() % 16 == 0;
        now += random() % 100 == 0 ? -1.0 : 0.005;
        listener.receive(frame, now);
        ++taken;
    }
    const TelemetryCounters c = listener.counters();
    std::uint64_t counted = c.used + c.fromConsole + c.repeated + c.wrongSequence;
    for (const std::uint64_t n : c.faults) counted += n;
    EXPECT_EQ(counted, taken);
    EXPECT_GT(c.used, 0U);
}

}  // namespace
}  // namespace terratact
