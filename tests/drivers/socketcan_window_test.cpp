// At most two frames of a CAN interface are sent without a confirmation.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drivers/socketcan.h"
#include "tests/drivers/fake_can_socket.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

TEST_F(OnABus, aThirdUnconfirmedFrameIsRefused)
{
    EXPECT_EQ(refusal(1), "");
    EXPECT_EQ(refusal(2), "");
    EXPECT_NE(refusal(3), "");
    EXPECT_EQ(kernel.written.size(), 2u);
    kernel.echo(frameOfId(1));
    EXPECT_EQ(receive(), 1u);
    EXPECT_TRUE(frames[0].echo);
    EXPECT_EQ(refusal(4), "");
    const BusCounters counters = bus->counters();
    EXPECT_EQ(counters.sent, 3u);
    EXPECT_EQ(counters.confirmed, 1u);
    EXPECT_EQ(counters.notSent, 1u);
}

TEST_F(OnABus, theEchoOfALaterFrameConfirmsThoseBefore)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.echo(frameOfId(2));
    (void)receive();
    EXPECT_EQ(refusal(3), "");
    EXPECT_EQ(refusal(4), "");
}

TEST_F(OnABus, somebodyElsesCopyConfirmsNothing)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.put(frameOfId(1));
    kernel.put(frameOfId(1), true);
    kernel.echo(frameOfId(7));  // an echo from an earlier socket
    (void)receive();
    EXPECT_NE(refusal(3), "");
}

TEST_F(OnABus, bytesBehindTheEndDoNotHideAnEcho)
{
    ASSERT_TRUE(bus->send({.id = 1, .length = 1, .data = {5, 6, 7}}));
    kernel.echo({.id = 1, .length = 1, .data = {5}});
    (void)receive();
    EXPECT_EQ(bus->counters().confirmed, 1u);
}

TEST_F(OnABus, busWithoutEchoesStallsAfter60Ms)
{
    ASSERT_EQ(refusal(1), "");
    kernel.pass(0.059);
    EXPECT_EQ(bus->state(), BusState::Up);
    kernel.pass(0.002);
    EXPECT_EQ(bus->state(), BusState::Stalled);
    EXPECT_NE(refusal(2).find("acknowledges"), std::string::npos) << "though the window has room";
    kernel.echo(frameOfId(1));
    (void)receive();
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(refusal(3), "");
}

TEST_F(OnABus, twoSecondsOfCommandsOnAStalledBusLeaveTwoFrames)
{
    for (int i = 0; i < 100; ++i) {
        (void)bus->send(frameOfId(0x100));
        (void)receive(20ms);
    }
    EXPECT_EQ(kernel.written.size(), 2u);
    EXPECT_EQ(bus->counters().notSent, 98u);
    EXPECT_EQ(bus->state(), BusState::Stalled);
}

TEST(SocketCan, withoutAWindowABurstLeavesAndAStallStillStopsIt)
{
    Kernel kernel;
    const auto bus = opened(kernel, {.transmit = true, .maxUnconfirmed = 0});
    for (std::uint32_t id = 0; id < 12; ++id) ASSERT_TRUE(bus->send(frameOfId(id)));
    kernel.pass(0.1);
    EXPECT_EQ(bus->state(), BusState::Stalled);
    EXPECT_FALSE(bus->send(frameOfId(12)));
}

TEST_F(OnABus, anEchoThatWasDroppedDoesNotCloseTheWindowForEver)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.drops = 5;
    (void)receive(300ms);
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(refusal(3), "");
    EXPECT_EQ(bus->counters().dropped, 5u);
}

}  // namespace
}  // namespace terratact
