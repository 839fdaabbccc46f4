#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/sim/robot_on_bus.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Ground under a simulated robot.
struct RobotGround {
    GroundLines lines;
    double start = 0.0;  ///< [m] start position
};

/// Returns the ground. terrain: a file of profiles or ground lines (its first ground is used), or "varied" for random
/// terrain of the seed. An empty terrain gives the built-in step with a run-up.
Result<RobotGround> robotGround(const std::string& terrain, std::uint64_t seed);

/// Adds a fault given as text: "silence", or "silence@12.5" for 12.5 s after the start. Sensor faults are read by
/// sensorFaultFrom(): "stuck:pitch@12.5".
Result<RobotOnBus::Options> withFault(RobotOnBus::Options robot, const std::string& text);

}  // namespace terratact
