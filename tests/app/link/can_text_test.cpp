// Tests CAN frames as text.
#include "app/link/can_text.h"

#include <gtest/gtest.h>

#include <string>

namespace terratact {
namespace {

CanFrame attitudeFrame(std::uint8_t counter, double measured = 1.0)
{
    return pack(
        {.kind = FrameKind::Attitude, .counter = counter, .values = {0.21, -0.05, measured}});
}

TEST(CanText, identifierShowsTheKindOfFrame)
{
    EXPECT_EQ(idText({.id = 0x44}), "044");
    EXPECT_EQ(idText({.id = 0x44, .extended = true}), "00000044");
    EXPECT_EQ(idText({.id = 0x44, .fd = true}), "044 FD");
    EXPECT_EQ(idText({.id = 0x44, .remote = true}), "044 remote");
    EXPECT_EQ(idText({.id = 0x4, .error = true}), "error 004");
    EXPECT_EQ(kindText({.extended = true, .fd = true}), "extended CAN FD frame");
    EXPECT_EQ(kindText({.remote = true}), "remote frame");
}

TEST(CanText, bytesOfATruncatedFrameEndWithAnEllipsis)
{
    CanFrame frame{.id = 1, .length = 3, .data = {0x2A, 0x00, 0xFF}};
    EXPECT_EQ(bytesText(frame), "[3] 2A 00 FF");
    frame.remote = true;
    EXPECT_EQ(bytesText(frame), "[3]") << "a remote frame has no data";
    EXPECT_EQ(bytesText({.id = 1, .fd = true, .length = 64, .isCut = true}),
              "[64] 00 00 00 00 00 00 00 00 …");
}

TEST(CanText, aValidFrameHasItsValuesInTheirUnits)
{
    const auto reader = frameReader(CanProtocol::Terratact);
    const CanFrame frame = attitudeFrame(1);
    const FrameWords words = reader->read(frame, 0.0);
    EXPECT_EQ(words.name, "Attitude");
    EXPECT_EQ(words.verdict, "ok");
    EXPECT_EQ(words.counter, 1);
    EXPECT_EQ(contentText(frame, words), "Pitch 0.2100 rad, Roll -0.0500 rad");
    EXPECT_EQ(reader->read(frame, 0.05).verdict, "repeated");
    EXPECT_EQ(reader->read(attitudeFrame(3), 0.1).verdict,
              "ok, but one or two before it are missing");
}

TEST(CanText, aFrameWithoutAMeasurementIsMarked)
{
    const auto reader = frameReader(CanProtocol::Terratact);
    const FrameWords words = reader->read(attitudeFrame(1, 0.0), 0.0);
    EXPECT_TRUE(isNotMeasured(words.values));
    EXPECT_EQ(wordsOf(words.values), "not measured");
}

TEST(CanText, aMissingCurrentHasNoValue)
{
    const auto reader = frameReader(CanProtocol::Terratact);
    const auto text = [&](std::uint8_t counter, double leftMissing) {
        const CanFrame frame = pack({.kind = FrameKind::FrontCurrents,
                                     .counter = counter,
                                     .values = {0.0, 1.7, 1.0, leftMissing, 0.0}});
        return wordsOf(reader->read(frame, 0.05 * counter).values);
    };
    EXPECT_EQ(text(1, 0.0), "Left 0.000 A, Right 1.700 A");
    EXPECT_EQ(text(2, 1.0), "Right 1.700 A, LeftMissing yes");
}

TEST(CanText, aDamagedFrameShowsItsBytesOnly)
{
    const auto reader = frameReader(CanProtocol::Terratact);
    CanFrame frame = attitudeFrame(1);
    frame.data[3] ^= 1U;
    const FrameWords words = reader->read(frame, 0.0);
    EXPECT_EQ(words.trouble, FrameTrouble::WrongChecksum);
    EXPECT_TRUE(words.values.empty());
    EXPECT_EQ(contentText(frame, words), bytesText(frame));
}

TEST(CanText, aDamagedStopStillStopsRobots)
{
    const auto reader = frameReader(CanProtocol::Terratact);
    CanFrame stop = frameOf(StopCommand{}, 1, 1);
    stop.data[0] ^= 1U;
    EXPECT_NE(reader->read(stop, 0.0).verdict.find("a robot still stops"), std::string::npos);
}

TEST(CanText, protocolsHaveTheirNames)
{
    EXPECT_EQ(canProtocolFromName("terratact"), CanProtocol::Terratact);
    EXPECT_EQ(canProtocolFromName("absolem"), CanProtocol::Absolem);
    EXPECT_FALSE(canProtocolFromName("Absolem"));
}

}  // namespace
}  // namespace terratact
