// Tests opening a bus or a log in its place.
#include "app/link/open_bus.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(OpenBus, aMissingInterfaceIsNamed)
{
    const auto bus = openBus("no-such-can");
    ASSERT_FALSE(bus);
    EXPECT_NE(bus.error().text.find("no-such-can"), std::string::npos) << bus.error().text;
}

TEST(OpenReplay, aLogOfSeveralInterfacesNeedsTheName)
{
    const TemporaryDirectory directory;
    const std::string log =
        directory.write("two.log", "(1.000000) can0 123#01\n(1.001000) can1 124#02\n");
    EXPECT_TRUE(refused(openReplay(log, "", 1000.0), log, {"can0", "can1"}));
    EXPECT_FALSE(openReplay(log, "can7", 1000.0)) << "no frame is of it";
    const auto replay = openReplay(log, "can1", 1000.0);
    ASSERT_TRUE(replay) << replay.error().text;
    std::array<BusFrame, 4> frames;
    const auto count = (*replay)->receive(frames, std::chrono::seconds(10));
    ASSERT_TRUE(count);
    ASSERT_EQ(*count, 1U);
    EXPECT_EQ(frames[0].frame.id, 0x124U);
}

}  // namespace
}  // namespace terratact
