#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "core/clouds/cloud_reader.h"
#include "core/clouds/pose_track.h"
#include "core/robot/two_tracks.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// How a generated cloud differs from the ground. Everything but the noise is exact.
struct MadeCloud {
    double density = 4000.0;  ///< points per square metre
    double noise = 0.01;      ///< [m] sd of a point's height
    double holes = 0.0;       ///< share of the area without points: discs of 5 to 15 cm radius
    double offset = 0.0;      ///< [m] added to every height
    std::size_t own = 0;      ///< points of the robot itself at each pose
};

/// Returns the pose of a robot's base in the frame of its drive: x along the drive, y left, z up. The tracks' lower
/// edges lie at ±Y cos φ from the drive's line.
CloudPose basePose(const RobotModel& robot, const TwoTrackPose& pose);

/// Returns points of the ground under a drive from x = begin to end [m], in the cloud's frame. They
/// reach 0.4 m to both sides. `drive`: pose of the drive's frame. Between the outer edge of a track
/// and the flippers the line under the part counts. Throws std::invalid_argument unless begin <
/// end, and for more than 1e8 points.
std::vector<CloudPoint> groundCloud(const RobotModel& robot, const GroundLines& ground,
                                    const CloudPose& drive, double begin, double end,
                                    const MadeCloud& made, std::mt19937_64& rng);

/// Returns points of the robot's tracks and flippers, 5 to 15 cm above their lower edges, in the cloud's frame.
std::vector<CloudPoint> robotCloud(const RobotModel& robot, const CloudPose& base,
                                   std::size_t count, std::mt19937_64& rng);

/// Returns the points as a PCD file, DATA binary, with floats of 4 bytes.
std::string pcdText(std::span<const CloudPoint> points);

}  // namespace terratact
