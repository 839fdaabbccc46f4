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

using Command = std::variant<StopCommand, ReleaseStopCommand, HaltCommand, DriveCommand,
                             PressCommand, ProbeCommand>;

}  // namespace terratact
