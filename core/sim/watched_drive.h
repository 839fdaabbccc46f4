#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/sim/drive.h"
#include "core/sim/simulated_robot.h"
#include "core/terrain/bins.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// A line of telemetry; with the true heights where it is the first of a press, of which a console makes a scene.
struct WatchedLine {
    Measurement measurement;
    std::optional<Heights> truth{};
};

/// How a drive with telemetry goes: drive, press the flippers down, stand, and drive on.
struct WatchedStyle {
    DriveStyle flippers{};
    double spacing = 0.3;    ///< [m] driven between two presses
    double speed = 0.3;      ///< [m/s]
    double standing = 1.3;   ///< [s] after a press
    double period = 0.05;    ///< [s] of telemetry
    bool comesBack = false;  ///< turns round at the end, and presses on the way back, too
};

inline constexpr double kTurning = 4.0;  ///< [s]

/// Every line that a SimulatedRobot sends on its way over the terrain, until it reaches the end, finds no rest
/// pose, or `most` lines.  A robot that comes back turns on the spot, in kTurning, and starts from where it stood;
/// its noise is another.
std::vector<WatchedLine> driveWithTelemetry(const RobotModel& robot, const TerrainProfile& terrain,
                                            const WatchedStyle& style, std::uint64_t seed,
                                            std::size_t most = 100'000);

}  // namespace terratact
