#include "drivers/memory_bus.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace terratact {
namespace {

using namespace std::chrono_literals;

CanFrame frameWith(std::uint32_t id)
{
    return {.id = id, .length = 1, .data = {0x5a}};
}

std::vector<BusFrame> all(CanBus& end)
{
    std::array<BusFrame, 3> some{};  // less room than frames: receive() continues where it ended
    std::vector<BusFrame> frames;
    for (;;) {
        const auto count = end.receive(some, 0ms);
        if (!count) throw std::runtime_error(count.error().text);
        if (*count == 0) return frames;
        frames.insert(frames.end(), some.begin(),
                      some.begin() + static_cast<std::ptrdiff_t>(*count));
    }
}

struct TwoEnds : testing::Test {
    double now = 0.0;
    MemoryBus bus{[this] { return now; }};
    std::unique_ptr<CanBus> console = bus.join("console"), robot = bus.join("robot", 0);
};

TEST_F(TwoEnds, deliversToTheOtherEndAndEchoes)
{
    now = 2.5;
    ASSERT_TRUE(console->send(frameWith(0x100)));
    const auto heard = all(*robot), echoed = all(*console);
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].frame, frameWith(0x100));
    EXPECT_EQ(heard[0].time, 2.5);
    EXPECT_FALSE(heard[0].echo || heard[0].local) << "to the robot it comes from another node";
    ASSERT_EQ(echoed.size(), 1u);
    EXPECT_TRUE(echoed[0].echo && echoed[0].local);
    EXPECT_EQ(console->counters().confirmed, 1u);
}

TEST_F(TwoEnds, aThirdFrameIsRefusedUntilAnEchoWasRead)
{
    ASSERT_TRUE(console->send(frameWith(1)));
    ASSERT_TRUE(console->send(frameWith(2)));
    EXPECT_FALSE(console->send(frameWith(3)));
    EXPECT_EQ(console->counters().notSent, 1u);
    (void)all(*console);
    EXPECT_TRUE(console->send(frameWith(4)));
}

TEST_F(TwoEnds, anEndWithoutAWindowSendsABurst)
{
    for (std::uint32_t id = 0; id < 12; ++id) ASSERT_TRUE(robot->send(frameWith(id)));
    EXPECT_EQ(all(*console).size(), 12u);
}

TEST_F(TwoEnds, aStalledBusDeliversLateAndOnlyTheWindow)
{
    bus.setState(BusState::Stalled);
    for (std::uint32_t id = 0; id < 10; ++id) (void)console->send(frameWith(id));
    EXPECT_TRUE(all(*robot).empty());
    bus.setState(BusState::Up);
    EXPECT_EQ(all(*robot).size(), 2u);
}

TEST_F(TwoEnds, anInterfaceThatGoesDownLosesWhatWasQueued)
{
    bus.setState(BusState::Stalled, "console");
    ASSERT_TRUE(console->send(frameWith(1)));
    bus.setState(BusState::Absent, "console");
    EXPECT_FALSE(console->send(frameWith(2)));
    bus.put(frameWith(3));
    bus.setState(BusState::Up, "console");
    EXPECT_TRUE(all(*console).empty()) << "neither the queued one nor what passed meanwhile";
    EXPECT_EQ(all(*robot).size(), 1u);
    EXPECT_EQ(console->counters().reopened, 1u);
    EXPECT_TRUE(console->send(frameWith(4)));
}

TEST_F(TwoEnds, countsDroppedFrames)
{
    bus.dropNext(2);
    for (std::uint32_t id = 0; id < 3; ++id) bus.put(frameWith(id), true);
    const auto heard = all(*robot);
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].frame.id, 2u);
    EXPECT_TRUE(heard[0].local && !heard[0].echo);
    EXPECT_EQ(robot->counters().dropped, 2u);
}

TEST_F(TwoEnds, aWaitingReaderIsWoken)
{
    std::jthread sender([this] { bus.put(frameWith(7)); });
    std::array<BusFrame, 1> one{};
    const auto count = robot->receive(one, 60s);  // a hang guard, not a limit
    ASSERT_TRUE(count);
    EXPECT_EQ(*count, 1u);
}

}  // namespace
}  // namespace terratact
