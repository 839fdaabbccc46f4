#pragma once

#include <memory>

#include "app/link/can_source.h"
#include "app/link/robot_in_process.h"
#include "app/recording/session_recorder.h"
#include "app/start/console_options.h"
#include "core/base/result.h"
#include "core/robot/robot_model.h"
#include "drivers/log_replay.h"
#include "drivers/memory_bus.h"
#include "drivers/operator_panel.h"

namespace terratact {

/// The simulated robot and its bus. Users of an end of that bus must not outlive it.
struct BuiltInRobot {
    BuiltInRobot(const RobotModel& model, const SimulatedRobot& simulated,
                 const RobotOnBus::Options& options);
    MemoryBus bus;
    RobotInProcess robot;
};

/// The source of telemetry and target of commands.
struct RobotConnection {
    std::unique_ptr<BuiltInRobot> builtIn;  ///< null: the robot is on a bus or in a log
    std::unique_ptr<CanSource> source;
    LogReplay* replay = nullptr;  ///< replay of the source, if it is a log
};

/// Connects to the bus or log of the command line, else to the simulated robot. The recorder receives every frame,
/// which may be null.
Result<RobotConnection> connectRobot(const RobotModel& robot, const ConsoleOptions& options,
                                     const std::shared_ptr<SessionRecorder>& recorder);

/// Opens the panel of the command line; null without one.
Result<std::unique_ptr<OperatorPanel>> openPanel(const ConsoleOptions& options);

}  // namespace terratact
