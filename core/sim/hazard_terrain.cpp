#include "core/sim/hazard_terrain.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/named.h"
#include "core/sim/random_terrain.h"
#include "core/sim/terrain_path.h"
#include "core/sim/terrain_shapes.h"

namespace terratact {
namespace {

constexpr auto kHazardNames =
    namesOf<Hazard>("drop", "gap", "pit", "ditch", "ramp-drop", "wall", "lip");

double between(std::mt19937_64& rng, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(rng);
}

double logBetween(std::mt19937_64& rng, double low, double high)
{
    return low * std::exp(between(rng, 0.0, std::log(high / low)));
}

void addDitch(TerrainPath& path, double depth, std::mt19937_64& rng)
{
    const double down = between(rng, 0.52, 1.22);
    const double up = between(rng, 0.52, 1.22);
    path.rise(depth / std::tan(down), -depth);
    path.level(between(rng, 0.0, 0.4));
    path.rise(depth / std::tan(up), depth);
}

void addHazardShape(TerrainPath& path, Hazard hazard, std::mt19937_64& rng)
{
    const double size = logBetween(rng, kShallowestHazard, kDeepestHazard);
    switch (hazard) {
    case Hazard::Drop: return path.face(-size);
    case Hazard::Wall: return path.face(size);
    case Hazard::Ditch: return addDitch(path, size, rng);
    case Hazard::Gap:
        path.face(-size);
        path.level(logBetween(rng, 0.15, 1.2));
        return path.face(size);
    case Hazard::Pit:
        path.face(-size);
        path.level(between(rng, 0.2, 1.2));
        return path.face(size + between(rng, -0.3, 0.3));
    case Hazard::RampDrop:
        path.slope(between(rng, 0.2, 0.8), between(rng, 0.05, 0.35));
        return path.face(-size);
    case Hazard::Lip: {
        const double lip = between(rng, 0.03, 0.12);
        path.face(lip);
        path.level(between(rng, 0.05, 0.15));
        return path.face(-size - lip);
    }
    }
    throw std::invalid_argument("addHazardShape: no such Hazard");
}

}  // namespace

std::string_view name(Hazard hazard)
{
    return nameIn(kHazardNames, hazard);
}

std::optional<Hazard> hazardFromName(std::string_view text)
{
    return valueIn<Hazard>(kHazardNames, text);
}

TerrainProfile randomHazardTerrain(Hazard hazard, double roughness, std::mt19937_64& rng)
{
    if (!(roughness >= 0.0) || !std::isfinite(roughness))
        throw std::invalid_argument("randomHazardTerrain: the roughness must be 0 m³ or more");
    TerrainPath path;
    path.level(between(rng, kHazardBegin, kHazardEnd));
    addHazardShape(path, hazard, rng);
    TerrainProfile ground = std::move(path).finish(kRandomTerrainLength);
    if (roughness == 0.0) return ground;
    return sum(ground, isoRoughness(roughness, kRandomTerrainLength, rng));
}

}  // namespace terratact
