#pragma once

#include <memory>

#include "app/link/can_source.h"
#include "app/link/robot_in_process.h"
#include "app/recording/session_recorder.h"
#include "app/shell/console_options.h"
#include "core/base/result.h"
#include "core/robot/robot_model.h"
#include "drivers/log_replay.h"
#include "drivers/memory_bus.h"
#include "drivers/operator_panel.h"

namespace terratact {

/// The built-in robot and its bus; whoever talks to it on an end of that must not outlive it.
struct BuiltInRobot {
    BuiltInRobot(const RobotModel& model, const SimulatedRobot& simulated,
                 const RobotOnBus::Options& options);
    MemoryBus bus;
    RobotInProcess robot;
};

/// Where telemetry comes from and commands go to.
struct RobotConnection {
    std::unique_ptr<BuiltInRobot> builtIn;  ///< null: the robot is on a bus, or in a log
    std::unique_ptr<CanSource> source;
    LogReplay* replay = nullptr;  ///< of the source, where it is a log
};

/// The robot on the bus or in the log that the command line names, else the built-in one.  Every frame goes to the
/// recorder, which may be null.
Result<RobotConnection> connectRobot(const RobotModel& robot, const ConsoleOptions& options,
                                     const std::shared_ptr<SessionRecorder>& recorder);

/// The panel that the command line names, else null.
Result<std::unique_ptr<OperatorPanel>> openPanel(const ConsoleOptions& options);

}  // namespace terratact
