#include "core/sim/terrain_shapes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace terratact {

namespace {

constexpr double kDriveLength = 6.0;  // [m]

double uniform(std::mt19937_64& rng, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(rng);
}

bool chance(std::mt19937_64& rng, double probability)
{
    return uniform(rng, 0.0, 1.0) < probability;
}

/// Grows a profile to the right, piece by piece.
class Path {
public:
    double x() const { return points_.back().x; }
    void level(double length) { points_.push_back({x() + length, z()}); }
    void face(double rise) { points_.push_back({x(), z() + rise}); }
    void slope(double length, double angle)
    {
        points_.push_back({x() + length, z() + length * std::tan(angle)});
    }
    TerrainProfile finish(double length)
    {
        if (x() < length) level(length - x());
        return TerrainProfile(points_);
    }

private:
    double z() const { return points_.back().z; }
    std::vector<Vec2> points_{{0.0, 0.0}};
};

void addStep(Path& path, std::mt19937_64& rng)
{
    const double height = uniform(rng, 0.04, 0.32);
    path.face(chance(rng, 0.6) ? height : -height);
    path.level(uniform(rng, 0.3, 1.5));
}

void addStairs(Path& path, std::mt19937_64& rng)
{
    const double riser = uniform(rng, 0.08, 0.18) * (chance(rng, 0.5) ? 1.0 : -1.0);
    const double tread = uniform(rng, 0.24, 0.34);
    const int count = std::uniform_int_distribution<int>(2, 5)(rng);
    for (int k = 0; k < count; ++k) {
        path.face(riser);
        path.level(tread);
    }
    path.level(uniform(rng, 0.2, 0.8));
}

void addSlope(Path& path, std::mt19937_64& rng)
{
    path.slope(uniform(rng, 0.4, 1.8), uniform(rng, -0.26, 0.26));
    path.level(uniform(rng, 0.1, 0.6));
}

/// A raised or sunken piece with vertical faces: block, kerb, ledge or hole.
void addBlock(Path& path, std::mt19937_64& rng, double least, double most, double widthLow,
              double widthHigh)
{
    const double height = uniform(rng, least, most);
    path.face(height);
    path.level(uniform(rng, widthLow, widthHigh));
    path.face(-height + (chance(rng, 0.3) ? uniform(rng, -0.05, 0.05) : 0.0));
    path.level(uniform(rng, 0.2, 1.0));
}

void addFeature(Path& path, std::mt19937_64& rng)
{
    switch (std::uniform_int_distribution<int>(0, 6)(rng)) {
    case 0: return addSlope(path, rng);
    case 1: return addStairs(path, rng);
    case 2: return addBlock(path, rng, 0.05, 0.30, 0.3, 1.5);     // block, ledge
    case 3: return addBlock(path, rng, 0.04, 0.15, 0.08, 0.25);   // kerb
    case 4: return addBlock(path, rng, -0.20, -0.04, 0.15, 0.6);  // hole
    default: return addStep(path, rng);
    }
}

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
    Path path;
    path.level(at);
    path.face(height);
    path.level(width);
    path.face(-height);
    return path.finish(length);
}

TerrainProfile stairsTerrain(double riser, double tread, int count, double at, double length)
{
    Path path;
    path.level(at);
    for (int k = 0; k < count; ++k) {
        path.face(riser);
        path.level(tread);
    }
    return path.finish(length);
}

TerrainProfile slopeTerrain(double angle, double at, double length)
{
    Path path;
    path.level(at);
    path.slope(length - at, angle);
    return path.finish(length);
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
    // a's own points keep its vertical faces: there b adds one height to both ends of the face.
    std::vector<Vec2> points;
    for (const Vec2 p : a.points()) points.push_back({p.x, p.z + b.heightAt(p.x)});
    for (const Vec2 p : b.points()) {
        const auto& own = a.points();
        const bool shared = std::any_of(own.begin(), own.end(), [&](Vec2 q) { return q.x == p.x; });
        if (!shared) points.push_back({p.x, p.z + a.heightAt(p.x)});
    }
    std::stable_sort(points.begin(), points.end(), [](Vec2 p, Vec2 q) { return p.x < q.x; });
    return TerrainProfile(std::move(points));
}

TerrainProfile randomBoxDrive(std::mt19937_64& rng)
{
    const double height = chance(rng, 0.5) ? 0.20 : 0.28;
    return boxTerrain(height, uniform(rng, 1.8, 2.6), uniform(rng, 0.8, 1.6), kDriveLength);
}

TerrainProfile randomVariedDrive(std::mt19937_64& rng)
{
    Path path;
    path.level(uniform(rng, 0.8, 1.6));
    const int features = std::uniform_int_distribution<int>(1, 4)(rng);
    for (int k = 0; k < features && path.x() < kDriveLength - 1.5; ++k) addFeature(path, rng);
    const TerrainProfile shape = path.finish(kDriveLength);
    const double sd = 0.03 * uniform(rng, 0.0, 1.0) * uniform(rng, 0.0, 1.0);
    return sum(shape, roughTerrain(sd, uniform(rng, 0.05, 0.4), kDriveLength, rng));
}

TerrainProfile demoTerrain()
{
    Path path;
    path.level(kDemoStep);
    path.face(0.24);
    path.level(1.4);
    for (int k = 0; k < 3; ++k) {
        path.face(-0.08);
        path.level(0.3);
    }
    std::mt19937_64 rng(20160203);
    return sum(path.finish(kDriveLength), roughTerrain(0.006, 0.15, kDriveLength, rng));
}

}  // namespace terratact
