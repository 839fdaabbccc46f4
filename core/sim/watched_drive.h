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

/// Line of telemetry. The first line of a press has the true heights, because a console captures it
/// as a scene.
struct WatchedLine {
    Measurement measurement;
    std::optional<Heights> truth{};
    Vec2
        imu{};  ///< [m] true position in the terrain's frame; on the way back that of the turned terrain
};

/// Style of a drive with telemetry: drive, press the flippers down, stand, and drive on.
struct WatchedStyle {
    DriveStyle flippers{};
    double spacing = 0.3;    ///< [m] driven between two presses
    double speed = 0.3;      ///< [m/s]
    double standing = 1.3;   ///< after a press [s]
    double period = 0.05;    ///< [s] of telemetry
    bool comesBack = false;  ///< turns round at the end, and also presses on the way back
};

inline constexpr double kTurning = 4.0;  ///< [s]

/// Returns every line that a SimulatedRobot sends on its way over the terrain. It ends at the
/// terrain's end, without a rest pose, or after `most` lines. A robot that comes back turns on the
/// spot within kTurning and starts from there, with other noise.
std::vector<WatchedLine> driveWithTelemetry(const RobotModel& robot, const TerrainProfile& terrain,
                                            const WatchedStyle& style, std::uint64_t seed,
                                            std::size_t most = 100'000);

/// Returns the way of the tracks [m] after a quarter of a turn.
double wayBack(const std::vector<WatchedLine>& drive);

}  // namespace terratact
