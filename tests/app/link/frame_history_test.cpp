//
#include "app/link/frame_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/link/bus_statistics.h"
#include "app/link/can_source.h"
#include "tests/support/absolem.h"
#include "tests/support/devices/frame_tap.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST_F(Tapping, keepsTheNewestValueAndTheExtremes)
{
    run(0.0, 1.0, 0.2);
    run(1.0, 2.0, -0.3);
    const TappedFrame frame = of(FrameKind::Attitude, 2.0);
    EXPECT_EQ(frame.frames, 40U);
    ASSERT_EQ(frame.payload.size(), 3U);
    EXPECT_NEAR(frame.payload[0].last.value(), -0.3, 1e-4);
    EXPECT_NEAR(frame.payload[0].least.value(), -0.3, 1e-4);
    EXPECT_NEAR(frame.payload[0].most.value(), 0.2, 1e-4);
    EXPECT_NEAR(frame.age.value(), 0.05, 1e-9);
    tap.forgetExtremes();
    EXPECT_FALSE(of(FrameKind::Attitude, 2.0).payload[0].least);
}

TEST_F(Tapping, countsTheRateAndForgetsIt)
{
    run(0.0, 5.0, 0.0);
    EXPECT_NEAR(of(FrameKind::Attitude, 5.0).rate, 20.0, 0.6);
    EXPECT_NEAR(tap.load().framesPerSecond, 20.0, 0.6);
    for (double t = 5.0; t < 8.0; t += 0.01) tap.tick(t);
    EXPECT_EQ(of(FrameKind::Attitude, 8.0).rate, 0.0);
    EXPECT_EQ(tap.load().framesPerSecond, 0.0);
    EXPECT_NEAR(of(FrameKind::Attitude, 8.0).age.value(), 3.05, 1e-9);
}

TEST_F(Tapping, givesTheLoadWithAndWithoutStuffBits)
{
    run(0.0, 5.0, 0.0);
    const BusLoad load = tap.load();
    const FrameBits bits = bitsOf(attitude(0.0, 0.0).frame);
    EXPECT_NEAR(load.fewestBits, load.framesPerSecond * bits.fewest, 1e-6);
    EXPECT_NEAR(load.mostBits, load.framesPerSecond * bits.most, 1e-6);
}

TEST_F(Tapping, historyHasGapsWhereNothingCame)
{
    run(0.0, 3.0, 0.5);
    for (double t = 3.0; t < 4.0; t += 0.01) tap.tick(t);
    run(4.0, 6.0, -0.5);
    const auto history = of(FrameKind::Attitude, 6.0).payload[0].history;
    const auto back = [&](double seconds) {
        return history[TappedSignal::kPoints - 1
                       - static_cast<std::size_t>(std::lround(seconds / FrameHistory::kTick))];
    };
    EXPECT_NEAR(back(0.0), -0.5, 1e-4) << "the newest is last";
    EXPECT_NEAR(back(1.5), -0.5, 1e-4);
    EXPECT_TRUE(std::isnan(back(2.4))) << "silence";
    EXPECT_NEAR(back(4.0), 0.5, 1e-4);
    EXPECT_TRUE(std::isnan(history[0])) << "before the beginning";
}

TEST_F(Tapping, takesNoValueFromAFrameThatMayNotBeUsed)
{
    add(attitude(0.1, 0.0));
    BusFrame damaged = attitude(0.9, 0.05);
    damaged.frame.data[4] ^= 0x10U;
    add(damaged);
    --counter;
    BusFrame old = attitude(0.8, 0.1);
    old.frame = pack({.kind = FrameKind::Attitude, .counter = 200, .values = {0.8, 0.0, 1.0}});
    add(old);
    const TappedFrame frame = of(FrameKind::Attitude, 0.2);
    EXPECT_NEAR(frame.payload[0].last.value(), 0.1, 1e-4);
    EXPECT_NEAR(frame.payload[0].most.value(), 0.1, 1e-4);
    EXPECT_NEAR(frame.age.value(), 0.2, 1e-9) << "of the last that may be used";
    EXPECT_EQ(frame.frames, 3U);
    EXPECT_EQ(frame.troubles[static_cast<std::size_t>(FrameTrouble::WrongChecksum)], 1U);
    EXPECT_EQ(frame.troubles[static_cast<std::size_t>(FrameTrouble::WrongSequence)], 1U);
    EXPECT_EQ(tap.load().troubles[static_cast<std::size_t>(FrameTrouble::WrongChecksum)], 1U);
}

TEST_F(Tapping, unmeasuredSignalsHaveNoExtremes)
{
    add({.frame = pack({.kind = FrameKind::Attitude, .counter = 1, .values = {0.0, 0.0, 0.0}}),
         .time = 0.0});
    const TappedFrame frame = of(FrameKind::Attitude, 0.0);
    EXPECT_FALSE(frame.isMeasured);
    EXPECT_FALSE(frame.payload[0].last);
    EXPECT_FALSE(frame.payload[0].least);
    EXPECT_EQ(frame.payload[2].last.value(), 0.0) << "that it was not measured is a value";
}

TEST_F(Tapping, aMissingCurrentHasNoValue)
{
    const auto currents = [](std::uint8_t number, double left, double isMissing) {
        return BusFrame{.frame = pack({.kind = FrameKind::RearCurrents,
                                       .counter = number,
                                       .values = {left, 1.7, 1.0, isMissing}}),
                        .time = 0.05 * number};
    };
    add(currents(1, 1.5, 0.0));
    add(currents(2, 0.0, 1.0));
    const TappedFrame frame = of(FrameKind::RearCurrents, 0.1);
    EXPECT_TRUE(frame.isMeasured);
    EXPECT_FALSE(frame.payload[0].last);
    EXPECT_NEAR(frame.payload[0].least.value(), 1.5, 1e-9) << "the last one that was measured";
    EXPECT_NEAR(frame.payload[1].last.value(), 1.7, 1e-9);
    EXPECT_EQ(frame.payload[3].last, 1.0);
}

TEST_F(Tapping, traceIsTheNewestFramesInTheirOrder)
{
    const auto total = static_cast<std::uint32_t>(FrameHistory::kTrace + 123);
    for (std::uint32_t i = 0; i < total; ++i)
        add({.frame = {.id = i % 2048, .length = 0}, .time = 0.001 * i});
    const auto trace = tap.trace();
    ASSERT_EQ(trace.size(), FrameHistory::kTrace);
    for (std::size_t i = 0; i < trace.size(); ++i) {
        ASSERT_EQ(trace[i].number, i + 124);
        ASSERT_EQ(trace[i].frame.id, (i + 123) % 2048);
    }
}

TEST_F(Tapping, memoryIsBoundedForAnyFrames)
{
    for (std::uint32_t id = 0; id < 100'000; ++id)
        add({.frame = {.id = id, .extended = true, .length = 8}, .time = 0.0});
    EXPECT_EQ(tap.frames(0.0).size(), ForeignFrames::kMaxUnknown);
    EXPECT_EQ(tap.load().frames, 100'000U);
    EXPECT_EQ(tap.load().beyond, 100'000U - ForeignFrames::kMaxUnknown);
    add({.frame = {.id = 4, .error = true, .length = 8}, .time = 0.0});
    EXPECT_EQ(tap.trace().back().trouble, FrameTrouble::Other);
}

TEST_F(Tapping, survivesATimeThatJumps)
{
    tap.tick(0.0);
    tap.tick(1e6);
    run(1e6, 1e6 + 3.0, 0.2);
    EXPECT_NEAR(of(FrameKind::Attitude, 1e6 + 3.0).rate, 20.0, 1.1);
    tap.tick(5.0);
    EXPECT_TRUE(std::isfinite(tap.load().framesPerSecond));
}

/// Returns a book with `messages` messages of `signalsOfEach` one-byte signals.
std::shared_ptr<const DbcBook> wideBook(unsigned messages, unsigned signalsOfEach)
{
    std::string text;
    for (unsigned m = 0; m < messages; ++m) {
        text += "BO_ " + std::to_string(256 + m) + " M: 8 P\n";
        for (unsigned s = 0; s < signalsOfEach; ++s)
            text += " SG_ S" + std::to_string(s) + " : " + std::to_string(8 * (s % 8))
                  + "|8@1+ (0.5,1) [0|0] \"\" C\n";
    }
    const TemporaryDirectory directory;
    auto book = std::make_shared<DbcBook>();
    EXPECT_TRUE(book->add(directory.write("wide.dbc", text)));
    return book;
}

TEST_F(Tapping, isBoundedWhateverFilesDescribe)
{
    tap.describe(wideBook(1000, 1));
    for (std::uint32_t id = 256; id < 1256; ++id) add({.frame = {.id = id, .length = 8}});
    constexpr std::size_t kRoom = ForeignFrames::kMaxDescribed + ForeignFrames::kMaxUnknown;
    EXPECT_EQ(tap.frames(0.0).size(), kRoom);
    EXPECT_EQ(tap.load().beyond, 1000 - kRoom);
    tap.describe(wideBook(10, 900));
    for (std::uint32_t id = 256; id < 266; ++id) add({.frame = {.id = id, .length = 8}});
    std::size_t described = 0;
    for (const TappedFrame& frame : tap.frames(0.0)) described += frame.described != nullptr;
    EXPECT_EQ(described, ForeignFrames::kMaxSignals / 900);
    EXPECT_EQ(tap.frames(0.0).size(), 10U) << "of the others the bytes";
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Returns one second of a full bus: a robot's telemetry and other nodes.
std::vector<BusFrame> fullBus(std::size_t frames)
{
    std::vector<BusFrame> made;
    std::uint8_t counter = 0;
    while (made.size() < frames) {
        const double time = static_cast<double>(made.size()) / 9000.0;
        if (made.size() % 45 == 0) {
            SensorLine line;
            line.attitude = SensorLine::Attitude{0.1, 0.0};
            for (const CanFrame& frame : framesOf(line, ++counter))
                made.push_back({.frame = frame, .time = time});
        } else {
            CanFrame frame{.id = 0x100 + static_cast<std::uint32_t>(made.size() % 32), .length = 8};
            made.push_back({.frame = frame, .time = time});
        }
    }
    return made;
}

template <class Take>
double secondsPerMillion(const std::vector<BusFrame>& frames, Take&& add)
{
    const double began = cpuSeconds();
    for (int round = 0; round < 5; ++round) add(frames);
    return (cpuSeconds() - began) / (5.0 * static_cast<double>(frames.size())) * 1e6;
}

TEST(FrameHistoryCost, isLessThanFormattingEveryFrame)
{
    const std::vector<BusFrame> frames = fullBus(40'000);
    FrameHistory tap;
    FrameHistory describing;
    describing.describe(wideBook(32, 8));
    const auto costOf = [&](FrameHistory& some) {
        return secondsPerMillion(frames, [&](const std::vector<BusFrame>& all) {
            FrameValidator validator;
            for (std::size_t i = 0; i < all.size(); ++i) {
                some.add(all[i], validator.judge(all[i].frame, all[i].time));
                if (i % 10 == 0) some.tick(all[i].time);
            }
        });
    };
    double tapped = costOf(tap);
    double described = costOf(describing);
    for (int again = 0; again < 2; ++again) {  // alternates, so that other load affects both
        tapped = std::min(tapped, costOf(tap));
        described = std::min(described, costOf(describing));
    }
    const auto reader = frameReader(CanProtocol::Terratact);
    BusStatistics statistics;
    const double worded = secondsPerMillion(frames, [&](const std::vector<BusFrame>& all) {
        for (const BusFrame& f : all)
            statistics.add(f.frame, reader->read(f.frame, f.time), f.time);
    });
    ConsoleLink link(absolem(), {});
    const double received = secondsPerMillion(frames, [&](const std::vector<BusFrame>& all) {
        for (const BusFrame& f : all) (void)link.receive(f.frame, f.echo, f.time);
    });
    std::printf("seconds of CPU per million frames: tap %.3f, with eight signals of a DBC file in "
                "each foreign frame %.3f, the link without it %.3f, every frame in words %.3f\n",
                tapped, described, received, worded);
    EXPECT_LT(tapped, worded);
    EXPECT_LT(described, 5.0 * tapped) << "nine signals are not nine times the frame";
    EXPECT_LT(tapped, 20.0) << "a fifth of a core at 9000 frames/s";
}

TEST(FrameHistoryThreads, isReadableWhileAdding)
{
    const std::vector<BusFrame> frames = fullBus(9000);
    FrameHistory tap;
    FrameValidator validator;
    std::atomic<bool> done = false;
    std::jthread receiver([&] {
        for (int round = 0; round < 3; ++round)
            for (const BusFrame& frame : frames) {
                tap.add(frame, validator.judge(frame.frame, frame.time));
                tap.tick(frame.time);
            }
        done = true;
    });
    std::uint64_t before = 0;
    while (!done) {
        const auto trace = tap.trace();
        for (std::size_t i = 1; i < trace.size(); ++i)
            ASSERT_EQ(trace[i].number, trace[i - 1].number + 1);
        (void)tap.frames(1.0);
        tap.forgetExtremes();
        const std::uint64_t now = tap.load().frames;
        ASSERT_GE(now, before);
        before = now;
    }
    EXPECT_EQ(tap.load().frames, 3 * frames.size());
}

}  // namespace
}  // namespace terratact
