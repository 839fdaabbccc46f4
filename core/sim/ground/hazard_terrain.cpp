#include "core/sim/ground/hazard_terrain.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/named.h"
#include "core/infer/estimate/hazards.h"
#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_path.h"
#include "core/sim/ground/terrain_shapes.h"

namespace terratact {
namespace {

constexpr auto kHazardNames =
    namesOf<Hazard>("drop", "gap", "pit", "ditch", "ramp-drop", "wall", "lip");

void addDitch(TerrainPath& path, double depth, std::mt19937_64& rng)
{
    const double down = uniform(rng, 0.52, 1.22);
    const double up = uniform(rng, 0.52, 1.22);
    path.rise(depth / std::tan(down), -depth);
    path.level(uniform(rng, 0.0, 0.4));
    path.rise(depth / std::tan(up), depth);
}

void addHazardShape(TerrainPath& path, Hazard hazard, std::mt19937_64& rng)
{
    const double size = logUniform(rng, kSmallestHazard, kLargestHazard);
    switch (hazard) {
    case Hazard::Drop: return path.face(-size);
    case Hazard::Wall: return path.face(size);
    case Hazard::Ditch: return addDitch(path, size, rng);
    case Hazard::Gap:
        path.face(-size);
        path.level(logUniform(rng, 0.15, 1.2));
        return path.face(size);
    case Hazard::Pit:
        path.face(-size);
        path.level(uniform(rng, 0.2, 1.2));
        return path.face(size + uniform(rng, -0.3, 0.3));
    case Hazard::RampDrop: {
        const double angle = uniform(rng, 0.05, 0.35);
        const double length = uniform(rng, 0.2, 0.8);
        path.slope(length, angle);
        return path.face(-size);
    }
    case Hazard::Lip: {
        const double lip = uniform(rng, 0.03, 0.12);
        path.face(lip);
        path.level(uniform(rng, 0.05, 0.15));
        return path.face(-size - lip);
    }
    }
    throw std::invalid_argument("addHazardShape: no such Hazard");
}

void checkRoughness(double roughness)
{
    if (!(roughness >= 0.0) || !std::isfinite(roughness))
        throw std::invalid_argument("randomHazardTerrain: the roughness must be 0 m³ or more");
}

/// Returns level ground, the hazard, and level ground.
TerrainProfile hazardShape(Hazard hazard, std::mt19937_64& rng)
{
    TerrainPath path;
    path.level(uniform(rng, kHazardBegin, kHazardEnd));
    addHazardShape(path, hazard, rng);
    return std::move(path).finish(kRandomTerrainLength);
}

}  // namespace

std::string_view name(Hazard hazard)
{
    return nameIn(kHazardNames, hazard);
}

TerrainProfile randomHazardTerrain(Hazard hazard, double roughness, std::mt19937_64& rng)
{
    checkRoughness(roughness);
    TerrainProfile ground = hazardShape(hazard, rng);
    if (roughness == 0.0) return ground;
    return sum(ground, isoRoughness(roughness, kRandomTerrainLength, rng));
}

GroundLines randomHazardGround(Hazard hazard, HazardSide side, double roughness,
                               const std::vector<double>& ys, std::mt19937_64& rng)
{
    checkRoughness(roughness);
    const TerrainProfile shape = hazardShape(hazard, rng);
    const TerrainProfile level = flatTerrain(kRandomTerrainLength);
    std::vector<GroundLine> lines;
    for (const double y : ys) {
        const bool has = side == HazardSide::Both || (side == HazardSide::Left) == (y > 0.0);
        lines.push_back({y, has ? shape : level});
    }
    if (roughness > 0.0)
        addRoughness(lines, roughness, uniform(rng, kMinCorrelation, kMaxCorrelation), rng);
    return GroundLines(std::move(lines));
}

}  // namespace terratact
