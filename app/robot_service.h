#pragma once

#include <functional>
#include <string>

#include "core/result.h"
#include "core/sim/robot_on_bus.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Lets the robot live on the bus as long as goOn() says so; `say` hears in words what changes, and `measured`
/// is called before a line of telemetry leaves.
Status serveRobot(
    CanBus& bus, RobotOnBus& robot, const std::function<bool()>& goOn,
    const std::function<void(const std::string&)>& say,
    const std::function<void()>& measured = [] {});

}  // namespace terratact
