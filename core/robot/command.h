#pragma once

#include <variant>

namespace terratact {

// What the console may ask of a robot.  SI units.
struct StopCommand {};         ///< halt everything and latch
struct ReleaseStopCommand {};  ///< let commands through again; moves nothing
struct HaltCommand {};         ///< stop driving, keep the pose
struct DriveCommand {
    double speed = 0.0;  ///< [m/s] forward positive, until Halt or the end of the terrain
};
struct PressCommand {
    double torque = 0.0;  ///< [N m] sum of both front flippers, pressing down positive
};
struct ProbeCommand {
    int bin = 0;  ///< bin to touch with the arm
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

/// Can only make a robot safer: obeyed in any state and any epoch, tried again until it has left.
inline bool makesSafe(const Command& command)
{
    if (const auto* arm = std::get_if<ArmCommand>(&command)) return !arm->armed;
    return std::holds_alternative<StopCommand>(command)
        || std::holds_alternative<HaltCommand>(command)
        || std::holds_alternative<AbortAtemCommand>(command);
}

}  // namespace terratact
