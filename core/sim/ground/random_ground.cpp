#include "core/sim/ground/random_ground.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_path.h"
#include "core/sim/ground/terrain_shapes.h"

namespace terratact {
namespace {

/// Returns correlation and innovation of an autoregression between lines at a distance [m].
std::pair<double, double> coupling(double distance, double correlation)
{
    const double keep = std::exp(-std::abs(distance) / correlation);
    return {keep, std::sqrt(1.0 - keep * keep)};
}

/// Returns a · p + b · q for profiles with the same x.
TerrainProfile blend(const TerrainProfile& p, double a, const TerrainProfile& q, double b)
{
    std::vector<Vec2> points = p.points();
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].z = a * points[i].z + b * q.points()[i].z;
    return TerrainProfile(std::move(points));
}

TerrainProfile raised(const TerrainProfile& profile, double height)
{
    std::vector<Vec2> points = profile.points();
    for (Vec2& p : points) p.z += height;
    return TerrainProfile(std::move(points));
}

/// Returns lines of the same ground that is crossed at an angle to its profile: the line at y has the
/// profile's height at s = x cos α + y sin α.
std::vector<GroundLine> crossed(const TerrainProfile& profile, double angle,
                                const std::vector<double>& ys)
{
    std::vector<GroundLine> lines;
    for (const double y : ys) {
        std::vector<Vec2> points = profile.points();
        for (Vec2& p : points) p.x = (p.x - y * std::sin(angle)) / std::cos(angle);
        lines.push_back({y, TerrainProfile(std::move(points))});
    }
    return lines;
}

/// Feature with vertical faces, on the lines whose y is beyond its inner edge.
struct OneSidedFeature {
    double height, width;  ///< [m]; a hole has a negative height
    double edge;           ///< [m] y of the inner edge on the left, mirrored on the right
    bool left;

    bool covers(double y) const { return left ? y > edge : -y > edge; }
};

OneSidedFeature randomFeature(std::mt19937_64& rng)
{
    OneSidedFeature f{};
    switch (whole(rng, 0, 2)) {
    case 0:  // block
        f.height = uniform(rng, 0.04, 0.35);
        f.width = uniform(rng, 0.2, 1.5);
        break;
    case 1:  // kerb
        f.height = uniform(rng, 0.04, 0.20);
        f.width = uniform(rng, 2.0, 5.0);
        break;
    default:  // hole
        f.height = -uniform(rng, 0.03, 0.25);
        f.width = uniform(rng, 0.1, 0.6);
    }
    f.edge = uniform(rng, -0.1, 0.24);
    f.left = chance(rng, 0.5);
    return f;
}

std::vector<GroundLine> finished(std::vector<TerrainPath> paths, const std::vector<double>& ys)
{
    std::vector<GroundLine> lines;
    lines.reserve(ys.size());
    for (std::size_t i = 0; i < ys.size(); ++i)
        lines.push_back({ys[i], std::move(paths[i]).finish(kRandomTerrainLength)});
    return lines;
}

std::vector<GroundLine> oneSidedGround(const std::vector<double>& ys, std::mt19937_64& rng)
{
    std::vector<TerrainPath> paths(ys.size());
    const auto levelAll = [&](double length) {
        for (TerrainPath& path : paths) path.level(length);
    };
    levelAll(uniform(rng, 0.3, 1.5));
    while (paths.front().x() < kRandomTerrainLength) {
        const OneSidedFeature feature = randomFeature(rng);
        for (std::size_t i = 0; i < ys.size(); ++i) {
            const double height = feature.covers(ys[i]) ? feature.height : 0.0;
            paths[i].face(height);
            paths[i].level(feature.width);
            paths[i].face(-height);
        }
        levelAll(uniform(rng, 0.2, 1.5));
    }
    std::vector<GroundLine> lines = finished(std::move(paths), ys);
    const double gn0 = classRoughness(uniform(rng, 0.0, 4.0));
    addRoughness(lines, gn0, uniform(rng, kMinCorrelation, kMaxCorrelation), rng);
    return lines;
}

/// Humps and hollows whose heights differ between the lines, common steps, and roughness.
std::vector<GroundLine> unevenNatural(double correlation, const std::vector<double>& ys,
                                      std::mt19937_64& rng)
{
    std::vector<TerrainPath> paths(ys.size());
    double length = uniform(rng, 0.2, 1.5);
    for (TerrainPath& path : paths) path.level(length);
    std::normal_distribution<double> normal;
    while (paths.front().x() < kRandomTerrainLength) {
        const bool hump = chance(rng, 0.7);
        const double size = hump ? uniform(rng, 0.03, 0.25) : eitherWay(rng, 0.03, 0.25);
        const double width = uniform(rng, 0.2, 1.2);
        double factor = normal(rng);
        for (std::size_t i = 0; i < ys.size(); ++i) {
            if (i > 0) {
                const auto [keep, fresh] = coupling(ys[i] - ys[i - 1], correlation);
                factor = keep * factor + fresh * normal(rng);
            }
            if (hump)
                paths[i].hump(width, size * std::clamp(factor, -1.5, 1.5));
            else
                paths[i].face(size);
        }
        length = uniform(rng, 0.2, 2.5);
        for (TerrainPath& path : paths) path.level(length);
    }
    std::vector<GroundLine> lines = finished(std::move(paths), ys);
    addRoughness(lines, classRoughness(uniform(rng, 3.0, 6.0)), correlation, rng);
    return lines;
}

/// A field of flat-topped posts. Neighbouring lines cross the same post with the probability
/// exp(−distance / correlation).
std::vector<GroundLine> unevenRubble(double correlation, const std::vector<double>& ys,
                                     std::mt19937_64& rng)
{
    const double tallest = uniform(rng, 0.05, 0.30);
    const double post = uniform(rng, 0.1, 0.3);
    std::vector<TerrainPath> paths(ys.size());
    std::vector<double> before(ys.size(), 0.0);
    while (paths.front().x() < kRandomTerrainLength) {
        double height = uniform(rng, 0.0, tallest);
        for (std::size_t i = 0; i < ys.size(); ++i) {
            const double fresh = uniform(rng, 0.0, tallest);
            if (i > 0 && !chance(rng, coupling(ys[i] - ys[i - 1], correlation).first))
                height = fresh;
            paths[i].face(height - before[i]);
            paths[i].level(post);
            before[i] = height;
        }
    }
    return finished(std::move(paths), ys);
}

std::vector<GroundLine> unevenGround(const std::vector<double>& ys, std::mt19937_64& rng)
{
    const double correlation = uniform(rng, kMinCorrelation, kMaxCorrelation);
    return chance(rng, 0.67) ? unevenNatural(correlation, ys, rng)
                             : unevenRubble(correlation, ys, rng);
}

std::vector<GroundLine> linesOf(GroundKind kind, const std::vector<double>& ys,
                                std::mt19937_64& rng)
{
    switch (kind) {
    case GroundKind::Symmetric: return crossed(randomVariedTerrain(rng), 0.0, ys);
    case GroundKind::Oblique: {
        const TerrainProfile profile = randomVariedTerrain(rng);
        return crossed(profile, uniform(rng, -0.7854, 0.7854), ys);
    }
    case GroundKind::OneSided: return oneSidedGround(ys, rng);
    case GroundKind::Uneven: return unevenGround(ys, rng);
    }
    throw std::invalid_argument("randomGround: no such GroundKind");
}

}  // namespace

std::vector<double> groundYs(const RobotModel& robot)
{
    std::vector<double> ys{robot.lateral.flipperY, robot.lateral.trackY, -robot.lateral.trackY,
                           -robot.lateral.flipperY};
    std::ranges::sort(ys, std::greater{});
    return ys;
}

GroundKind randomGroundKind(std::mt19937_64& rng)
{
    const double kind = uniform(rng, 0.0, 1.0);
    if (kind < 0.15) return GroundKind::Symmetric;
    if (kind < 0.50) return GroundKind::Oblique;
    if (kind < 0.70) return GroundKind::OneSided;
    return GroundKind::Uneven;
}

GroundLines randomGround(GroundKind kind, const std::vector<double>& ys, std::mt19937_64& rng)
{
    std::vector<GroundLine> lines = linesOf(kind, ys, rng);
    const bool isMap = chance(rng, 0.5);
    if (isMap && (kind == GroundKind::OneSided || kind == GroundKind::Uneven))
        for (GroundLine& line : lines) line.profile = asElevationMap(line.profile, kBinWidth);
    const double slope = std::tan(uniform(rng, -0.2618, 0.2618));
    if (chance(rng, 1.0 / 3.0))
        for (GroundLine& line : lines) line.profile = raised(line.profile, line.y * slope);
    return GroundLines(std::move(lines));
}

void addRoughness(std::vector<GroundLine>& lines, double gn0, double correlation,
                  std::mt19937_64& rng)
{
    TerrainProfile rough = isoRoughness(gn0, kRandomTerrainLength, rng);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            const auto [keep, fresh] = coupling(lines[i].y - lines[i - 1].y, correlation);
            rough = blend(rough, keep, isoRoughness(gn0, kRandomTerrainLength, rng), fresh);
        }
        lines[i].profile = sum(lines[i].profile, rough);
    }
}

}  // namespace terratact
