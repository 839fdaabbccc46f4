#pragma once

#include <vector>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Line of the ground along x.
struct GroundLine {
    double y = 0.0;  ///< [m] left positive
    TerrainProfile profile;
};

/// Ground under a robot with two tracks: lines along x at different y. Every part of the robot
/// stands over the line that is nearest to the part's middle. Ground of a single line is a plane's
/// profile: left and right are equal.
class GroundLines {
public:
    /// Ground that is equal at every y.
    explicit GroundLines(TerrainProfile everywhere);

    /// Throws std::invalid_argument without a line, or if a y is not finite or stands twice. All
    /// lines must have a common range of x.
    explicit GroundLines(std::vector<GroundLine> lines);

    /// Returns the lines from left to right.
    const std::vector<GroundLine>& lines() const { return lines_; }

    /// Returns the line nearest to y; of two that are equally near, the one nearer to the middle.
    const TerrainProfile& under(double y) const;

    /// Returns true if all lines have the same points.
    bool isOnePlane() const;

    /// Return the range of x that every line covers [m].
    double begin() const;
    double end() const;

    /// Returns the ground with left and right exchanged.
    GroundLines mirrored() const;

private:
    std::vector<GroundLine> lines_;
};

/// Returns the true bin heights of one side for a DEM origin (the IMU) at `imu` in the terrain's
/// frame. Bins −0.3 … 0.2 m, under the tracks, are means of the line at the track's y. Bins from
/// 0.3 m on are those of the line at the flippers' y, which the front flipper feels.
Heights sideHeights(const GroundLines& terrain, const RobotModel& robot, Side side, Vec2 imu);

/// First bin of a side whose height is that of the flippers' line: +0.3 m.
inline constexpr int kFirstFlipperBin = 6;

}  // namespace terratact
