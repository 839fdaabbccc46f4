#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "core/clouds/pose_track.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Lines along the robot under which its parts lie.
enum class TruthLine : std::uint8_t { LeftTrack, LeftFlippers, RightTrack, RightFlippers };
inline constexpr std::size_t kTruthLines = 4;

constexpr Side sideOf(TruthLine line)
{
    return line < TruthLine::RightTrack ? Side::Left : Side::Right;
}
constexpr bool isUnderFlippers(TruthLine line)
{
    return line == TruthLine::LeftFlippers || line == TruthLine::RightFlippers;
}

/// A scene in the cloud: the DEM frame at the IMU, with x along the robot's heading and z up.
struct ScenePlace {
    std::size_t row = 0;  ///< of the scenes file
    TwoTrackReadings s;
    Eigen::Vector3d imu = Eigen::Vector3d::Zero();  ///< in the cloud's frame [m]
    double heading = 0.0;                           ///< [rad] in the cloud's frame
    double posePitch = 0.0, poseRoll = 0.0;         ///< [rad] of the pose, as in s

    /// Returns a point of the cloud in the DEM frame.
    Eigen::Vector3d toDem(const Eigen::Vector3d& point) const;
    /// Returns a point of the DEM frame in the cloud's frame.
    Eigen::Vector3d toCloud(const Eigen::Vector3d& dem) const;
};

/// Returns the place of a scene whose base has this pose in the cloud. Heading comes from the pose; pitch and
/// roll of the robot are the scene's, because gravity measured them.
ScenePlace placeOf(const RobotModel& robot, std::size_t row, const TwoTrackReadings& s,
                   const CloudPose& base);

/// Returns y of the middle of a line's strip in the DEM frame [m]. It is where the part's lower
/// edge lies on a rolled robot. It is ±Y cos φ + d sin φ; d: the IMU's height above the tracks'
/// lower edge.
double lineY(const RobotModel& robot, TruthLine line, double roll);

/// Returns half of the strip's width [m]: that of the part, at least 2 cm.
double lineHalfWidth(const RobotModel& robot, TruthLine line);

/// Returns the lower boundary of the part above a line at x in the DEM frame. The part is the track, or the
/// front or rear flipper; +infinity where there is none.
double partAbove(const RobotModel& robot, const TwoTrackReadings& s, TruthLine line, double x);

/// Returns x of the robot's centre of mass in the DEM frame [m].
double massX(const RobotModel& robot, const TwoTrackReadings& s);

}  // namespace terratact
