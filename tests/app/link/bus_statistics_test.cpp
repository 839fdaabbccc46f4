#include "app/link/bus_statistics.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

CanFrame frame(std::uint8_t length, bool extended = false)
{
    return {.id = 0x44, .extended = extended, .length = length};
}

// Compares with the frame rates of can-utils at 1 Mbit/s.
TEST(FrameBitsOnTheBus, areThoseOfCanUtils)
{
    EXPECT_EQ(1'000'000 / bitsOf(frame(8)).most, 7407);
    EXPECT_EQ(1'000'000 / bitsOf(frame(8)).fewest, 9009);
    EXPECT_EQ(1'000'000 / bitsOf(frame(0)).most, 18'181);
    EXPECT_EQ(1'000'000 / bitsOf(frame(0)).fewest, 21'276);
    EXPECT_EQ(1'000'000 / bitsOf(frame(8, true)).most, 6250);
    EXPECT_EQ(1'000'000 / bitsOf(frame(8, true)).fewest, 7633);
}

TEST(FrameBitsOnTheBus, ofARemoteFrameAreThoseOfAnEmptyOne)
{
    EXPECT_EQ(bitsOf({.id = 1, .remote = true, .length = 8}).most, bitsOf(frame(0)).most);
    EXPECT_EQ(bitsOf({.id = 1, .fd = true, .length = 8}).most, 0);
    EXPECT_EQ(bitsOf({.id = 1, .error = true, .length = 8}).most, 0);
}

TEST(CountingABus, separatesKindsThatShareAnIdentifier)
{
    BusStatistics statistics;
    const FrameWords words{.name = "Stop", .verdict = "ok"};
    statistics.add(frame(8), words, 1.0);
    statistics.add(frame(8), words, 1.5);
    statistics.add(frame(8), words, 1.7);
    statistics.add(frame(8, true), {}, 1.8);
    CanFrame remote = frame(0);
    remote.remote = true;
    statistics.add(remote, {}, 1.8);
    EXPECT_EQ(statistics.counts().size(), 3U);
    const FrameCount& count = statistics.counts().at(keyOf(frame(8), words));
    EXPECT_EQ(count.frames, 3U);
    EXPECT_EQ(count.first, 1.0);
    EXPECT_EQ(count.time, 1.7);
    EXPECT_NEAR(count.longest, 0.5, 1e-12);
    EXPECT_EQ(statistics.frames(), 5U);
    EXPECT_EQ(statistics.fewestBits(), 3U * 111 + 131 + 47);
    EXPECT_EQ(statistics.mostBits(), 3U * 135 + 160 + 55);
}

TEST(CountingABus, isBoundedByTheNumberOfKinds)
{
    BusStatistics statistics;
    for (std::uint32_t id = 0; id < 5000; ++id)
        statistics.add({.id = id, .extended = true}, {.trouble = FrameTrouble::Unknown}, 0.0);
    statistics.add({.id = 0, .extended = true}, {.trouble = FrameTrouble::Unknown}, 0.0);
    EXPECT_EQ(statistics.counts().size(), BusStatistics::kMaxKeys);
    EXPECT_EQ(statistics.beyond(), 5000 - BusStatistics::kMaxKeys);
    EXPECT_EQ(statistics.frames(), 5001U);
    const std::string text = summaryText(statistics, std::nullopt);
    EXPECT_NE(text.find("904 more frames of kinds beyond the first 4096"), std::string::npos);
    EXPECT_NE(text.find("4097 frames of 4096 unknown kinds"), std::string::npos);
}

TEST(CountingABus, addsUpWhatWasWrong)
{
    BusStatistics statistics;
    const auto add = [&](FrameTrouble trouble, double now) {
        statistics.add(frame(8), {.name = "Stop", .trouble = trouble}, now);
    };
    add(FrameTrouble::None, 0.0);
    add(FrameTrouble::Gap, 0.5);
    add(FrameTrouble::WrongChecksum, 1.0);
    add(FrameTrouble::WrongSequence, 1.5);
    add(FrameTrouble::Other, 2.0);
    const std::string text = summaryText(statistics, 2.0);
    EXPECT_NE(
        text.find("5 frames in 2.000 s: 1 with a wrong checksum, 1 out of sequence, 1 gaps, 1 "
                  "otherwise wrong; 0 frames of 0 unknown kinds"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("     2.0     0.500"), std::string::npos) << "rate and longest gap\n"
                                                                  << text;
}

}  // namespace
}  // namespace terratact
