#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include "app/modelling/simulation/hazard_scenes.h"
#include "core/learn/data/drive_lines.h"
#include "core/robot/robot_model.h"
#include "core/sim/ground/hazard_terrain.h"

namespace terratact {

/// Manoeuvres of a scripted drive near a hazard, besides driving straight on. Each has a stop every 0.1 m.
enum class Manoeuvre : std::uint8_t {
    Curve,    ///< bends that are too gentle to break the memory of the way
    Turn,     ///< turns on the spot by 0.02 … 0.5 rad, there and often back
    Reverse,  ///< drives back by 0.1 … 0.5 m, and forward again over the same ground
    Probe,    ///< the arm measures bins ahead on both sides at every second stop
    Mixed,    ///< all of these
};
inline constexpr std::array kManoeuvres{Manoeuvre::Curve, Manoeuvre::Turn, Manoeuvre::Reverse,
                                        Manoeuvre::Probe, Manoeuvre::Mixed};

/// Returns "curve", "turn", "reverse", "probe" or "mixed".
std::string_view name(Manoeuvre manoeuvre);

/// A line of a scripted drive, with the arm's readings if it is a scene where the arm probed.
struct ManoeuvreLine {
    DriveLine driven;
    std::vector<ArmReading> arm{};
};

/// Drives the simulated robot with two tracks from before the hazard. It ends when the robot has
/// passed, or has no rest pose any more. The hazard lies across the way, or beside it beyond an
/// edge. Only a turned robot reaches a hazard beside the way with a flipper. The ground is known
/// everywhere: at each pose, the lines under tracks and flippers are cut from it along the heading.
///   travelled   as driveWay(), with a slip of 10 %; it decreases while the robot reverses
///   turned      with 2 % and 0.002 rad of error per turn
///   arm         height at the bin's centre with a noise of 0.01 m; its sd is ArmReading's
std::vector<ManoeuvreLine> driveManoeuvre(const RobotModel& robot, const HazardGround& ground,
                                          std::optional<Hazard> hazard, Manoeuvre manoeuvre,
                                          std::mt19937_64& rng);

}  // namespace terratact
