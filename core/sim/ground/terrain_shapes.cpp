#include "core/sim/ground/terrain_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/sim/ground/terrain_path.h"

namespace terratact {

namespace {

constexpr double kDemoLength = 6.0;  // [m]

}  // namespace

TerrainProfile flatTerrain(double length)
{
    return TerrainProfile({{0.0, 0.0}, {length, 0.0}});
}

TerrainProfile stepTerrain(double height, double at, double length)
{
    return TerrainProfile({{0.0, 0.0}, {at, 0.0}, {at, height}, {length, height}});
}

TerrainProfile boxTerrain(double height, double at, double width, double length)
{
    TerrainPath path;
    path.level(at);
    path.face(height);
    path.level(width);
    path.face(-height);
    return std::move(path).finish(length);
}

TerrainProfile slopeTerrain(double angle, double at, double length)
{
    TerrainPath path;
    path.level(at);
    path.slope(length - at, angle);
    return std::move(path).finish(length);
}

TerrainProfile roughTerrain(double sd, double correlation, double length, std::mt19937_64& rng)
{
    constexpr double kStep = 0.01;
    const double keep = std::exp(-kStep / correlation);
    std::normal_distribution<double> normal;
    std::vector<double> heights{sd * normal(rng)};
    const auto count = static_cast<std::size_t>(std::lround(length / kStep));
    while (heights.size() <= count)
        heights.push_back(keep * heights.back() + sd * std::sqrt(1.0 - keep * keep) * normal(rng));
    return TerrainProfile::fromSamples(heights, kStep, false);
}

TerrainProfile sum(const TerrainProfile& a, const TerrainProfile& b)
{
    // The points of a keep its vertical faces: b adds one height to both ends of the face.
    const auto before = [](Vec2 p, Vec2 q) { return p.x < q.x; };
    std::vector<Vec2> points;
    for (const Vec2 p : a.points()) points.push_back({p.x, p.z + b.heightAt(p.x)});
    for (const Vec2 p : b.points()) {
        const auto& own = a.points();
        if (!std::binary_search(own.begin(), own.end(), p, before))
            points.push_back({p.x, p.z + a.heightAt(p.x)});
    }
    std::stable_sort(points.begin(), points.end(), before);
    return TerrainProfile(std::move(points));
}

TerrainProfile demoTerrain()
{
    TerrainPath path;
    path.level(kDemoStep);
    path.face(0.24);
    path.level(1.4);
    for (int k = 0; k < 3; ++k) {
        path.face(-0.08);
        path.level(0.3);
    }
    std::mt19937_64 rng(20160203);
    return sum(std::move(path).finish(kDemoLength), roughTerrain(0.006, 0.15, kDemoLength, rng));
}

}  // namespace terratact
