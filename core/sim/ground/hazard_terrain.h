#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "core/terrain/ground_lines.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Hazard at the end of level ground.
///   Drop        a vertical fall, level ground below
///   Gap         a hole with vertical faces and level ground behind, 0.15 … 1.2 m long
///   Pit         a hole whose far side lies up to 0.3 m higher or lower
///   Ditch       slopes of 30° … 70° down and up again
///   RampDrop    a ramp of up to 20° and a vertical fall behind it
///   Wall        a vertical rise
/// Lip a raised edge of 0.03 … 0.12 m, 0.05 … 0.15 m long, before a fall, like an overhang
enum class Hazard : std::uint8_t { Drop, Gap, Pit, Ditch, RampDrop, Wall, Lip };

inline constexpr std::array kHazards{Hazard::Drop,     Hazard::Gap,  Hazard::Pit, Hazard::Ditch,
                                     Hazard::RampDrop, Hazard::Wall, Hazard::Lip};

/// Returns "drop", "gap", "pit", "ditch", "ramp-drop", "wall" or "lip".
std::string_view name(Hazard hazard);

/// Range of the hazard's x in randomHazardTerrain [m].
inline constexpr double kHazardBegin = 2.0;
inline constexpr double kHazardEnd = 3.0;

/// Returns level ground from x = 0, the hazard between kHazardBegin and kHazardEnd, and level
/// ground up to kRandomTerrainLength (core/sim/ground/random_terrain.h). The hazard's depth or
/// height is log-uniform in [kSmallestHazard, kLargestHazard] (core/infer/estimate/hazards.h).
///   roughness: G(n₀) [m³] of isoRoughness() added everywhere; 0: exactly level ground.
TerrainProfile randomHazardTerrain(Hazard hazard, double roughness, std::mt19937_64& rng);

/// Sides of a robot on which a hazard lies.
enum class HazardSide : std::uint8_t { Left, Right, Both };

/// Returns randomHazardTerrain() under two tracks, with a line at each y of `ys`. A hazard on one side
/// ends at y = 0, and the other side is level. Roughness is correlated between the lines
/// (core/sim/ground/random_ground.h).
GroundLines randomHazardGround(Hazard hazard, HazardSide side, double roughness,
                               const std::vector<double>& ys, std::mt19937_64& rng);

}  // namespace terratact
