// Tests how a console goes on after it could not connect.
#include "app/console/next_start.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

const Message kReason = Message::verbatim("can1 is down");

ConsoleOptions onBus(const char* bus)
{
    ConsoleOptions options;
    options.can = bus;
    options.transmit = true;
    options.panel = "panel.toml";
    return options;
}

TEST(NextStart, aFirstStartThatFailsEndsTheProgram)
{
    EXPECT_FALSE(startAfter(onBus("can0"), std::nullopt, std::nullopt, kReason));
}

TEST(NextStart, theFormerConnectionReturns)
{
    const auto next = startAfter(onBus("can1"), onBus("can0"), std::nullopt, kReason);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->options.can, "can0");
    EXPECT_TRUE(next->options.transmit);
    EXPECT_EQ(next->why.english(), "not connected: can1 is down");
}

TEST(NextStart, theSimulatedRobotIsTheLastWayAndGivesBothReasons)
{
    const Message trouble = Message::verbatim("not connected: can1 is down");
    const Message reason = Message::verbatim("can0 is gone");
    const auto next = startAfter(onBus("can0"), std::nullopt, trouble, reason);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->options.can, "");
    EXPECT_FALSE(next->options.transmit);
    EXPECT_EQ(next->options.panel, "");
    EXPECT_EQ(next->why.english(),
              "not connected: can1 is down. The former connection failed, too: can0 is gone. This "
              "is the simulated robot");
    EXPECT_FALSE(startAfter(next->options, std::nullopt, next->why, reason)) << "no way is left";
}

}  // namespace
}  // namespace terratact
