#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/sim/robot_on_bus.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// What a simulated robot stands on.
struct RobotGround {
    TerrainProfile profile;
    double start = 0.0;  ///< [m] where the robot begins
};

/// terrain: a file of profiles, of which the first counts; "varied" for a random one of that seed; empty for
/// the built-in step, with some way to go to it.
Result<RobotGround> robotGround(const std::string& terrain, std::uint64_t seed);

/// Adds a fault in words, "silence" or "silence@12.5" for 12.5 s after the start; also one of sensors, as
/// sensorFaultFrom() reads it: "stuck:pitch@12.5".
Result<RobotOnBus::Options> withFault(RobotOnBus::Options robot, const std::string& text);

}  // namespace terratact
