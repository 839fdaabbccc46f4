#include "core/sim/ground/random_terrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/terrain_path.h"
#include "core/sim/ground/terrain_shapes.h"

namespace terratact {

namespace {

void addStep(TerrainPath& path, std::mt19937_64& rng)
{
    path.face(eitherWay(rng, 0.03, 0.40));
}

void addStairs(TerrainPath& path, std::mt19937_64& rng)
{
    const double riser = eitherWay(rng, 0.08, 0.20);
    const double tread = uniform(rng, 0.22, 0.40);
    const int count = whole(rng, 2, 12);
    for (int k = 0; k < count; ++k) {
        path.face(riser);
        path.level(tread);
    }
}

void addRamp(TerrainPath& path, std::mt19937_64& rng)
{
    const double angle = uniform(rng, -0.52, 0.52);
    path.slope(uniform(rng, 0.2, 2.0), angle);
}

struct Range {
    double low, high;
};

/// Adds a raised or, with sign −1, sunken piece with vertical faces.
void addBlock(TerrainPath& path, double sign, Range heights, Range widths, std::mt19937_64& rng)
{
    const double width = uniform(rng, widths.low, widths.high);
    const double height = sign * uniform(rng, heights.low, heights.high);
    path.face(height);
    path.level(width);
    path.face(-height * (chance(rng, 0.7) ? 1.0 : uniform(rng, 0.3, 1.3)));
}

void addHump(TerrainPath& path, std::mt19937_64& rng)
{
    const double height = eitherWay(rng, 0.03, 0.25);
    path.hump(uniform(rng, 0.2, 1.2), height);
}

void addFeature(TerrainPath& path, std::mt19937_64& rng)
{
    switch (whole(rng, 0, 9)) {
    case 0:
    case 1: return addStairs(path, rng);
    case 2:
    case 3: return addRamp(path, rng);
    case 4: return addBlock(path, 1.0, {0.04, 0.35}, {0.2, 1.5}, rng);
    case 5: return addBlock(path, 1.0, {0.03, 0.18}, {0.06, 0.25}, rng);
    case 6: return addBlock(path, -1.0, {0.03, 0.25}, {0.1, 0.6}, rng);
    case 7: return addHump(path, rng);
    default: return addStep(path, rng);
    }
}

/// Returns the length of a landing; short ones are more frequent.
double landing(std::mt19937_64& rng)
{
    return 0.05 + 1.5 * std::pow(uniform(rng, 0.0, 1.0), 2.0);
}

TerrainProfile builtGround(std::mt19937_64& rng)
{
    TerrainPath path;
    path.level(uniform(rng, 0.0, 1.5));
    while (path.x() < kRandomTerrainLength) {
        addFeature(path, rng);
        path.level(landing(rng));
    }
    // A line at an angle to head-on crosses the same ground stretched by 1 / cos.
    const double widest = uniform(rng, 0.0, 1.05);
    const double stretch = 1.0 / std::cos(widest * uniform(rng, 0.0, 1.0));
    return std::move(path).stretched(stretch);
}

TerrainProfile naturalGround(std::mt19937_64& rng)
{
    TerrainPath path;
    path.level(uniform(rng, 0.2, 1.5));
    while (path.x() < kRandomTerrainLength) {
        if (chance(rng, 0.7))
            addHump(path, rng);
        else
            path.face(eitherWay(rng, 0.03, 0.25));
        path.level(uniform(rng, 0.2, 2.5));
    }
    return sum(std::move(path).finish(kRandomTerrainLength), randomRoughness(3.0, 6.0, rng));
}

TerrainProfile stepField(std::mt19937_64& rng)
{
    const double tallest = uniform(rng, 0.05, 0.30);
    const double post = uniform(rng, 0.1, 0.3);
    TerrainPath path;
    double before = 0.0;
    while (path.x() < kRandomTerrainLength) {
        const double now = uniform(rng, 0.0, tallest);
        path.face(now - before);
        path.level(post);
        before = now;
    }
    return std::move(path).finish(kRandomTerrainLength);
}

TerrainProfile someGround(std::mt19937_64& rng)
{
    const double kind = uniform(rng, 0.0, 1.0);
    if (kind < 0.50) {
        const TerrainProfile built = builtGround(rng);
        return sum(built, randomRoughness(0.0, 4.0, rng));
    }
    if (kind < 0.75) return naturalGround(rng);
    if (kind < 0.85) return stepField(rng);
    const TerrainProfile built = builtGround(rng);
    return sum(built, randomRoughness(3.0, 6.0, rng));
}

}  // namespace

double classRoughness(double roughnessClass)
{
    return 16e-6 * std::pow(4.0, roughnessClass);
}

TerrainProfile randomRoughness(double fromClass, double toClass, std::mt19937_64& rng)
{
    return isoRoughness(classRoughness(uniform(rng, fromClass, toClass)), kRandomTerrainLength,
                        rng);
}

TerrainProfile randomBoxTerrain(std::mt19937_64& rng)
{
    const double height = chance(rng, 0.5) ? 0.20 : 0.28;
    const double at = uniform(rng, 1.8, 2.6);
    return boxTerrain(height, at, uniform(rng, 0.8, 1.6), kRandomTerrainLength);
}

TerrainProfile randomVariedTerrain(std::mt19937_64& rng)
{
    TerrainProfile ground = someGround(rng);
    if (chance(rng, 0.3))
        ground = sum(ground, slopeTerrain(uniform(rng, -0.35, 0.35), 0.0, kRandomTerrainLength));
    return chance(rng, 0.5) ? asElevationMap(ground, kBinWidth) : ground;
}

TerrainProfile isoRoughness(double gn0, double length, std::mt19937_64& rng)
{
    constexpr double kN0 = 0.1, kLowest = 0.25, kHighest = 10.0;  // [cycles/m]
    constexpr int kWaves = 60;
    constexpr double kStep = 0.02;  // [m]
    const double ratio = std::pow(kHighest / kLowest, 1.0 / kWaves);
    const auto posts = static_cast<std::size_t>(std::lround(length / kStep)) + 1;
    std::vector<double> heights(posts, 0.0);
    for (int wave = 0; wave < kWaves; ++wave) {
        // One cosine at a random place in the band has the band's share of the variance, ∫ G(n) dn.
        const double low = kLowest * std::pow(ratio, wave);
        const double high = low * ratio;
        const double amplitude = std::sqrt(2.0 * gn0 * kN0 * kN0 * (1.0 / low - 1.0 / high));
        const double n = uniform(rng, low, high);
        const double phase = uniform(rng, 0.0, 2.0 * std::numbers::pi);
        for (std::size_t k = 0; k < posts; ++k)
            heights[k] +=
                amplitude
                * std::cos(2.0 * std::numbers::pi * n * kStep * static_cast<double>(k) + phase);
    }
    return TerrainProfile::fromSamples(heights, kStep, false);
}

TerrainProfile asElevationMap(const TerrainProfile& terrain, double cell)
{
    std::vector<Vec2> points;
    const auto cells = static_cast<int>(std::floor((terrain.end() - terrain.begin()) / cell));
    for (int k = 0; k < std::max(cells, 1); ++k) {
        const double from = terrain.begin() + cell * k;
        points.push_back({from + 0.5 * cell, terrain.meanOver(from, from + cell)});
    }
    return TerrainProfile(std::move(points));
}

}  // namespace terratact
