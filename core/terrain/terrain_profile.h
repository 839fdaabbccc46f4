#pragma once

#include <vector>

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// No coordinate of a terrain is further from 0 [m].
inline constexpr double kFarthest = 1e6;

/// Ground under a drive: a line through points with x never decreasing, steps included as two points at
/// the same x.  Beyond its ends the ground goes on level.
class TerrainProfile {
public:
    /// points: at least one, x non-decreasing, all within kFarthest, else std::invalid_argument.
    explicit TerrainProfile(std::vector<Vec2> points);

    /// Heights [m] at equal steps [m], joined by straight lines, or as flat-topped blocks with
    /// vertical faces, each `step` wide.  The first point or the first block's centre is at x = 0.
    static TerrainProfile fromSamples(const std::vector<double>& heights, double step, bool blocks);

    const std::vector<Vec2>& points() const { return points_; }
    double begin() const { return points_.front().x; }
    double end() const { return points_.back().x; }

    /// Height at x; at a step the upper one.
    double heightAt(double x) const;

    /// Mean height over [a, b], exact for the line.  Throws std::invalid_argument unless a < b.
    double meanOver(double a, double b) const;

    /// The line between a and b with no segment longer than `spacing` in x or z (vertical faces kept).
    /// Throws std::invalid_argument unless a < b, spacing > 0, and where that would be more than 1e7 points.
    std::vector<Vec2> sampled(double a, double b, double spacing) const;

private:
    std::vector<Vec2> points_;
};

/// True bin heights seen from a DEM origin (the IMU) at `imu` in the terrain's frame.
Heights binHeights(const TerrainProfile& terrain, Vec2 imu);

}  // namespace terratact
