// Tests texts about the bus.
#include "app/mission/text/bus_text.h"

#include <gtest/gtest.h>

#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

TEST(StillComes, countsUsableFramesOfTheRobotOnly)
{
    const auto frame = [](std::optional<FrameKind> kind, std::optional<double> age) {
        TappedFrame made;
        made.kind = kind;
        made.age = age;
        return made;
    };
    EXPECT_EQ(stillComes({}, 1.0), "");
    EXPECT_EQ(
        stillComes({frame(FrameKind::RobotHeartbeat, 0.1), frame(FrameKind::Attitude, 0.8)}, 1.0),
        "frames still come, heartbeat 100 ms old");
    EXPECT_EQ(
        stillComes({frame(FrameKind::RobotHeartbeat, 3.0), frame(FrameKind::Odometry, 0.02)}, 1.0),
        "frames still come, heartbeat 3.0 s old");
    EXPECT_EQ(
        stillComes({frame(FrameKind::RobotHeartbeat, {}), frame(FrameKind::Odometry, 0.02)}, 1.0),
        "frames still come");
    EXPECT_EQ(
        stillComes({frame(FrameKind::RobotStatus, 0.5), frame(FrameKind::Odometry, 0.02)}, 1.0),
        "frames still come, status 500 ms old");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotHeartbeat, 0.26)}, 1.0), "");
    EXPECT_EQ(stillComes({frame(FrameKind::ConsoleHeartbeat, 0.0), frame({}, 0.0)}, 1.0), "")
        << "neither is the robot's";
    EXPECT_EQ(stillComes({frame(FrameKind::Odometry, 0.14)}, 0.26), "")
        << "it came with the last telemetry";
    EXPECT_EQ(stillComes({frame(FrameKind::Odometry, 0.12)}, 0.26), "frames still come");
}

}  // namespace
}  // namespace terratact
