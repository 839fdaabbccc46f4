#pragma once

#include <functional>
#include <string>

#include "app/runtime/steady_now.h"
#include "core/base/result.h"
#include "core/sim/robot_on_bus.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Runs the robot on the bus while goOn() returns true. `print` receives state changes as text; `measured` is called
/// before each telemetry line is sent. clock: the robot's monotonic clock [s].
Status serveRobot(
    CanBus& bus, RobotOnBus& robot, const std::function<bool()>& goOn,
    const std::function<void(const std::string&)>& print,
    const std::function<void()>& measured = [] {},
    const std::function<double()>& clock = steadyNow);

}  // namespace terratact
