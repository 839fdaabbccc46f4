#pragma once

#include <random>
#include <utility>
#include <vector>

#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/two_track_rest.h"

namespace terratact {

/// Pressed front flippers and held rear ones.
inline const PerFlipper<FlipperDrive> kDrives = flipperDrives(PressTorque{18.0}, HoldAngle{0.2});

/// Returns lines under tracks and flippers: common varied ground, roughness of each line, and a
/// cross slope.
inline GroundLines someGround(std::mt19937_64& rng)
{
    const TerrainProfile common = randomVariedTerrain(rng);
    const double slope = std::uniform_real_distribution<double>(-0.2, 0.2)(rng);
    std::vector<GroundLine> lines;
    for (const double y : {0.272, 0.1985, -0.1985, -0.272}) {
        const TerrainProfile rough = isoRoughness(1024e-6, kRandomTerrainLength, rng);
        const TerrainProfile level({{0.0, y * slope}, {kRandomTerrainLength, y * slope}});
        lines.push_back({y, sum(sum(common, rough), level)});
    }
    return GroundLines(std::move(lines));
}

/// Returns an x [m] at which the robot stands on the ground as a whole.
inline double placeOn(const GroundLines& ground, std::mt19937_64& rng)
{
    return std::uniform_real_distribution<double>(ground.begin() + 0.7, ground.end() - 0.8)(rng);
}

}  // namespace terratact
