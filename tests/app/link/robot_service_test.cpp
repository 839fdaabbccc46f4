// Tests a robot that serves a bus.
#include "app/link/robot_service.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/sim/ground/terrain_shapes.h"
#include "core/wire/can_codec.h"
#include "drivers/memory_bus.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

struct RobotServing : testing::Test {
    /// Serves `turns` turns of 5 ms; `before` runs before each.
    void serve(
        int turns, const std::function<void(int)>& before = [](int) {})
    {
        int turn = 0;
        const Status served = serveRobot(
            *end, robot,
            [&] {
                before(turn);
                now += 0.005;
                return turn++ < turns;
            },
            [&](const std::string& text) { states.push_back(text); }, [&] { ++lines; },
            [&] { return now; });
        EXPECT_TRUE(served) << served.error().text;
    }
    std::vector<CanFrame> received()
    {
        std::array<BusFrame, 256> frames;
        std::vector<CanFrame> all;
        const auto count = console->receive(frames, std::chrono::milliseconds(0));
        for (std::size_t i = 0; count && i < *count; ++i)
            if (!frames[i].echo) all.push_back(frames[i].frame);
        return all;
    }

    double now = 0.0;  // [s]
    MemoryBus bus{[this] { return now; }};
    std::unique_ptr<CanBus> end = bus.join("robot", 0), console = bus.join("console", 0);
    RobotModel model = absolem();
    RobotOnBus robot{model, SimulatedRobot(model, demoTerrain(), {}), {}};
    std::vector<std::string> states;
    int lines = 0;
};

TEST_F(RobotServing, sendsTelemetryEveryPeriodOfItsClock)
{
    serve(200);  // 1 s
    EXPECT_NEAR(lines, 1.0 / RobotOnBus::kPeriod, 1.0);
    std::set<std::uint32_t> kinds;
    for (const CanFrame& frame : received()) {
        EXPECT_TRUE(std::holds_alternative<Unpacked>(unpack(frame)));
        kinds.insert(frame.id);
    }
    EXPECT_GT(kinds.size(), 5U);
}

TEST_F(RobotServing, reportsEachChangeOfStateOnce)
{
    serve(100, [&](int turn) {
        if (turn == 50) (void)console->send(frameOf(StopCommand{}, 1, 1));
    });
    ASSERT_EQ(states.size(), 2U);
    EXPECT_NE(states[0].find("disarmed"), std::string::npos) << states[0];
    EXPECT_EQ(states[1].find(describe(RobotActivity::Stopped).english), 0U) << states[1];
}

TEST_F(RobotServing, aBusThatFailsIsReportedAndServedAgain)
{
    serve(60, [&](int turn) {
        if (turn == 20) bus.setState(BusState::Down, "robot");
        if (turn == 40) bus.setState(BusState::Up, "robot");
    });
    ASSERT_EQ(states.size(), 3U);
    EXPECT_EQ(states[1], describe(BusState::Down, "robot").english());
    EXPECT_EQ(states[2], states[0]);
}

}  // namespace
}  // namespace terratact
