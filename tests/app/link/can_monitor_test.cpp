#include "app/link/can_monitor.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/wire/can_codec.h"

namespace terratact {
namespace {

std::string rowOf(const CanMonitor& monitor, double now, const std::string& name)
{
    for (const std::string& row : monitor.table(now))
        if (row.find(name) != std::string::npos) return row;
    return "no row of " + name;
}

testing::AssertionResult says(const std::string& text, const std::string& part)
{
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << text << "\" does not say " << part;
}

struct Monitoring : testing::Test {
    CanMonitor monitor{CanProtocol::Terratact, 500'000.0};
    std::uint8_t counter = 0;

    void addHeartbeat(double time)
    {
        monitor.add({.frame = robotHeartbeat(0x1234, ++counter), .time = time});
    }
};

TEST_F(Monitoring, showsValueRateAndAge)
{
    monitor.mark(0.0);
    for (int i = 1; i <= 20; ++i) addHeartbeat(0.05 * i);
    monitor.mark(1.0);
    const std::string row = rowOf(monitor, 1.25, "RobotHeartbeat");
    EXPECT_TRUE(says(row, "021 "));
    EXPECT_TRUE(says(row, "  20.0    0.25  Token 4660"));
}

TEST_F(Monitoring, forgetsRatesOfLongAgo)
{
    monitor.mark(0.0);
    for (int i = 1; i <= 20; ++i) addHeartbeat(0.05 * i);
    for (double now = 1.0; now < 4.1; now += 0.2) monitor.mark(now);
    const std::string row = rowOf(monitor, 4.0, "RobotHeartbeat");
    EXPECT_TRUE(says(row, "   0.0    3.00  Token 4660")) << "a value stays, its age tells";
}

TEST_F(Monitoring, givesTheLoadWithoutStuffBitsAndWithTheMost)
{
    monitor.mark(0.0);
    for (int i = 0; i < 1000; ++i) addHeartbeat(0.001 * i);
    EXPECT_TRUE(says(monitor.headline("can0: working", {}), "can0: working; load - of 500 kbit/s"));
    monitor.mark(1.0);
    const std::string text =
        monitor.headline("can0: working", {.received = 1000, .dropped = 7, .errorFrames = 2});
    EXPECT_TRUE(says(text, "load 22.2 to 27.0 % of 500 kbit/s"));
    EXPECT_TRUE(says(text, "1000 frames, 7 dropped, 2 error frames"));
}

TEST_F(Monitoring, showsTheFaultOfTheNewestFrame)
{
    addHeartbeat(0.0);
    CanFrame damaged = robotHeartbeat(0x1234, 2);
    damaged.data[5] ^= 0x10U;
    monitor.add({.frame = damaged, .time = 0.1});
    EXPECT_TRUE(says(rowOf(monitor, 0.2, "RobotHeartbeat"), "(wrong checksum)"));
    monitor.add({.frame = {.id = 0x7AB, .length = 1, .data = {0x5A}}, .time = 0.1});
    EXPECT_TRUE(says(rowOf(monitor, 0.2, "7AB"), "unknown"));
    EXPECT_TRUE(says(rowOf(monitor, 0.2, "7AB"), "[1] 5A (unknown identifier)"));
}

TEST_F(Monitoring, givesEachValueOfAnAbsolemItsRow)
{
    CanMonitor absolem(CanProtocol::Absolem, 500'000.0);
    const auto add = [&](std::uint32_t id, std::array<std::uint8_t, kFdBytes> data,
                         std::uint8_t length) {
        absolem.add({.frame = {.id = id, .length = length, .data = data}, .time = 0.0});
    };
    add(0x307, {'p', 'x', 0, 0x40}, 4);
    add(0x287, {'P', 'X', 0, 0, 0xDC, 0x05, 0, 0}, 8);
    add(0x307, {'i', 'q', 0, 0x40}, 4);
    add(0x287, {'I', 'Q', 0, 0x80, 0, 0, 0x80, 0x3F}, 8);
    EXPECT_TRUE(
        says(rowOf(absolem, 0.0, "front left flipper PX "), "PX 1500 counts, angle 1.5708 rad"));
    EXPECT_TRUE(
        says(rowOf(absolem, 0.0, "front left flipper IQ "), "IQ 1.000 A, pressing down -1.000 A"));
}

TEST(AMonitor, needsABitrate)
{
    EXPECT_THROW(CanMonitor(CanProtocol::Terratact, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
