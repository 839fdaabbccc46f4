#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Builds a profile from (0, 0) to the right, piece by piece.
class TerrainPath {
public:
    double x() const { return points_.back().x; }
    void rise(double length, double height)
    {
        points_.push_back({x() + length, points_.back().z + height});
    }
    void level(double length) { rise(length, 0.0); }
    void face(double height) { rise(0.0, height); }
    void slope(double length, double angle) { rise(length, length * std::tan(angle)); }

    /// Adds half a wave up or down: a log, a mound, a furrow.
    void hump(double width, double height)
    {
        constexpr int kPosts = 16;
        double before = 0.0;
        for (int k = 1; k <= kPosts; ++k) {
            const double now = height * std::sin(std::numbers::pi * k / kPosts);
            rise(width / kPosts, now - before);
            before = now;
        }
    }

    /// Returns the profile, with level ground up to `length`.
    TerrainProfile finish(double length) &&
    {
        if (x() < length) level(length - x());
        return TerrainProfile(std::move(points_));
    }
    /// Returns the profile with every x multiplied by `factor`.
    TerrainProfile stretched(double factor) &&
    {
        for (Vec2& p : points_) p.x *= factor;
        return TerrainProfile(std::move(points_));
    }

private:
    std::vector<Vec2> points_{{0.0, 0.0}};
};

}  // namespace terratact
