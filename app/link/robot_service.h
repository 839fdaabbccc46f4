#pragma once

#include <functional>
#include <string>

#include "app/runtime/steady_now.h"
#include "core/base/result.h"
#include "core/sim/robot_on_bus.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Lets the robot live on the bus as long as goOn() says so; `say` hears in words what changes, and `measured`
/// is called before a line of telemetry leaves.  clock: [s] monotonic, the robot's.
Status serveRobot(
    CanBus& bus, RobotOnBus& robot, const std::function<bool()>& goOn,
    const std::function<void(const std::string&)>& say,
    const std::function<void()>& measured = [] {},
    const std::function<double()>& clock = steadyNow);

}  // namespace terratact
