#pragma once

#include <vector>

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Largest distance of a terrain coordinate from 0 [m].
inline constexpr double kFarthest = 1e6;

/// Ground under a drive: a line through points whose x never decreases. A vertical step is two
/// points at the same x. The ground is level beyond its ends.
class TerrainProfile {
public:
    /// points: at least one, x non-decreasing, all within kFarthest. Throws std::invalid_argument
    /// otherwise.
    explicit TerrainProfile(std::vector<Vec2> points);

    /// Returns a profile from heights [m] at equal steps [m]. They are joined by straight lines, or
    /// become flat-topped blocks with vertical faces, each `step` wide. The first point or the
    /// first block's centre is at x = 0.
    static TerrainProfile fromSamples(const std::vector<double>& heights, double step, bool blocks);

    const std::vector<Vec2>& points() const { return points_; }
    double begin() const { return points_.front().x; }
    double end() const { return points_.back().x; }

    /// Returns the height at x; at a vertical step the upper one.
    double heightAt(double x) const;

    /// Returns the mean height over [a, b], exact for the line. Throws std::invalid_argument unless
    /// a < b.
    double meanOver(double a, double b) const;

    /// Returns the line between a and b with segments of at most `spacing` in x and z. Vertical
    /// faces are kept. Throws std::invalid_argument unless a < b and spacing > 0, and for more than
    /// 1e7 points.
    std::vector<Vec2> sampled(double a, double b, double spacing) const;

private:
    std::vector<Vec2> points_;
};

/// Returns the line through heights at the centres of their bins.
TerrainProfile throughBins(const Heights& heights);

/// Returns the true bin heights for a DEM origin (the IMU) at `imu` in the terrain's frame.
Heights binHeights(const TerrainProfile& terrain, Vec2 imu);

}  // namespace terratact
