#pragma once

#include <variant>

#include "core/robot/probe_side.h"

namespace terratact {

// Commands from the console to a robot. SI units.
struct StopCommand {};         ///< halt everything and latch
struct ReleaseStopCommand {};  ///< accept commands again; moves nothing
struct HaltCommand {};         ///< stop driving, keep the pose
struct DriveCommand {
    double speed = 0.0;  ///< [m/s] forward positive, until Halt or the end of the terrain
};
struct PressCommand {
    double torque = 0.0;  ///< [N m] sum of both front flippers, pressing down positive
};
struct ProbeCommand {
    int bin = 0;  ///< bin to touch with the arm
    ProbeSide side = ProbeSide::Middle;
};
struct ArmCommand {
    bool armed = false;  ///< false: disarm
};
struct BeginAtemCommand {};  ///< an exploration begins: halt, and refuse to drive until it ends
struct AbortAtemCommand {};  ///< the exploration ends: halt
struct HoldFlippersCommand {
    double front = 0.0, rear = 0.0;  ///< [rad] tip up positive
};
struct AdvanceCommand {
    double distance = 0.0;  ///< [m] forward, then halt
};

using Command = std::variant<StopCommand, ReleaseStopCommand, HaltCommand, DriveCommand,
                             PressCommand, ProbeCommand, ArmCommand, BeginAtemCommand,
                             AbortAtemCommand, HoldFlippersCommand, AdvanceCommand>;

/// Returns the safety rank of a command. A rank above 0 can only make a robot safer. The robot
/// obeys such a command in any state and any epoch. The console repeats it until it is sent. A
/// higher rank includes the effect of every lower one.
inline int safety(const Command& command)
{
    if (std::holds_alternative<StopCommand>(command)) return 4;
    if (const auto* arm = std::get_if<ArmCommand>(&command)) return arm->armed ? 0 : 3;
    if (std::holds_alternative<AbortAtemCommand>(command)) return 2;
    return std::holds_alternative<HaltCommand>(command) ? 1 : 0;
}

}  // namespace terratact
