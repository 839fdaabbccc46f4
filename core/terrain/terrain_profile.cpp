#include "core/terrain/terrain_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace terratact {

namespace {

constexpr double kMaxSamples = 1e7;

double between(Vec2 p, Vec2 q, double x)
{
    return q.x > p.x ? p.z + (q.z - p.z) * (x - p.x) / (q.x - p.x) : std::max(p.z, q.z);
}

}  // namespace

TerrainProfile::TerrainProfile(std::vector<Vec2> points) : points_(std::move(points))
{
    if (points_.empty()) throw std::invalid_argument("a terrain profile needs at least one point");
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!(std::abs(points_[i].x) <= kFarthest && std::abs(points_[i].z) <= kFarthest))
            throw std::invalid_argument(
                "a terrain profile's points must be numbers within 1000 km of 0");
        if (i > 0 && points_[i].x < points_[i - 1].x)
            throw std::invalid_argument("a terrain profile's x must not decrease");
    }
}

TerrainProfile TerrainProfile::fromSamples(const std::vector<double>& heights, double step,
                                           bool blocks)
{
    if (!(step > 0.0)) throw std::invalid_argument("a terrain's step must be positive");
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double x = step * static_cast<double>(i);
        if (blocks) {
            points.push_back({x - 0.5 * step, heights[i]});
            points.push_back({step * (static_cast<double>(i) + 1.0) - 0.5 * step, heights[i]});
        } else {
            points.push_back({x, heights[i]});
        }
    }
    return TerrainProfile(std::move(points));
}

double TerrainProfile::heightAt(double x) const
{
    if (x < begin()) return points_.front().z;
    if (x > end()) return points_.back().z;
    const auto above = [](double value, Vec2 p) { return value < p.x; };
    const auto right = std::upper_bound(points_.begin(), points_.end(), x, above);
    const auto left = std::prev(right);
    double height = right == points_.end() ? left->z : between(*left, *right, x);
    for (auto p = left; p->x == x; --p) {  // at a vertical step all points of this x count
        height = std::max(height, p->z);
        if (p == points_.begin()) break;
    }
    return height;
}

double TerrainProfile::meanOver(double a, double b) const
{
    if (!(a < b)) throw std::invalid_argument("a mean needs an interval of positive length");
    double area = 0.0;
    if (a < begin()) area += points_.front().z * (std::min(b, begin()) - a);
    if (b > end()) area += points_.back().z * (b - std::max(a, end()));
    const auto less = [](Vec2 p, double value) { return p.x < value; };
    auto q = std::lower_bound(points_.begin(), points_.end(), a, less);
    if (q == points_.begin() && q != points_.end()) ++q;
    for (; q != points_.end() && std::prev(q)->x < b; ++q) {
        const Vec2 p = *std::prev(q);
        const double lo = std::max(a, p.x);
        const double hi = std::min(b, q->x);
        if (hi > lo) area += 0.5 * (between(p, *q, lo) + between(p, *q, hi)) * (hi - lo);
    }
    return area / (b - a);
}

std::vector<Vec2> TerrainProfile::sampled(double a, double b, double spacing) const
{
    if (!(a < b) || !(spacing > 0.0))
        throw std::invalid_argument("sampling needs an interval and a spacing of positive length");
    const auto less = [](Vec2 p, double value) { return p.x < value; };
    std::vector<Vec2> corners{{a, heightAt(a)}};
    for (auto p = std::lower_bound(points_.begin(), points_.end(), a, less);
         p != points_.end() && p->x <= b; ++p)
        corners.push_back(*p);
    corners.push_back({b, heightAt(b)});

    std::vector<Vec2> line{corners.front()};
    double count = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vec2 p = corners[i - 1];
        const Vec2 q = corners[i];
        const double longest = std::max(q.x - p.x, std::abs(q.z - p.z));
        if (longest == 0.0) continue;
        const double wanted = std::max(1.0, std::ceil(longest / spacing - 1e-9));
        count += wanted;
        if (!(count <= kMaxSamples))
            throw std::invalid_argument("a terrain sampled this finely would have too many points");
        const int pieces = static_cast<int>(wanted);
        for (int k = 1; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            line.push_back({p.x + t * (q.x - p.x), p.z + t * (q.z - p.z)});
        }
    }
    return line;
}

TerrainProfile throughBins(const Heights& heights)
{
    std::vector<Vec2> points;
    points.reserve(kBins);
    for (int bin = 0; bin < kBins; ++bin)
        points.push_back({binCentre(bin), heights[static_cast<std::size_t>(bin)]});
    return TerrainProfile(std::move(points));
}

Heights binHeights(const TerrainProfile& terrain, Vec2 imu)
{
    Heights h{};
    for (int i = 0; i < kBins; ++i)
        h[static_cast<std::size_t>(i)] =
            terrain.meanOver(imu.x + binBegin(i), imu.x + binEnd(i)) - imu.z;
    return h;
}

}  // namespace terratact
