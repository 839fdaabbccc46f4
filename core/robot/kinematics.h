#pragma once

#include <limits>
#include <vector>

#include "core/robot/robot_model.h"

namespace terratact {

/// Pose of the robot: base origin in a frame along gravity, pitch (nose up) and flipper angles.
struct Pose {
    Vec2 base;           ///< [m]
    double pitch = 0.0;  ///< [rad] nose up positive
    double front = 0.0;  ///< [rad] tip up positive
    double rear = 0.0;   ///< [rad] tip up positive
};

/// Returns the vector rotated by `angle` [rad], x towards z.
Vec2 rotated(Vec2 v, double angle);

/// Transforms a point from the base frame to the pose's frame.
Vec2 toWorld(const Pose& pose, Vec2 pointInBase);

/// Returns the IMU in the pose's frame: the origin of the DEM frame.
Vec2 imuPosition(const RobotModel& robot, const Pose& pose);

/// Returns the distance that the tracks roll between two nearby poses [m], forward positive. It is
/// the base's motion along the tracks at the mean of the two pitches.
double trackWay(const Pose& from, const Pose& to);

/// Returns the pose whose frame is the DEM frame: origin at the IMU, axes along gravity.
Pose poseInDem(const RobotModel& robot, double pitch, double front, double rear);

/// Returns the unit vector from a flipper's pivot to its tip circle, base frame:
///   front (cos(θ − taper), sin(θ − taper)), rear mirrored in x.
Vec2 flipperAxis(const FlipperGeometry& flipper, double angle);

/// Parts of the robot as convex shapes in the pose's frame.
struct RobotShape {
    TaperedHull track, front, rear;
    std::vector<std::vector<Vec2>> body;  ///< convex polygons
};
RobotShape shapeAt(const RobotModel& robot, const Pose& pose);

/// Return single parts of shapeAt().
TaperedHull trackAt(const RobotModel& robot, const Pose& pose);
TaperedHull flipperAt(const FlipperGeometry& flipper, double angle, const Pose& pose);

/// Returns the largest distance [m] of any point of the robot from its base origin, for any flipper
/// angles.
double reachOf(const RobotModel& robot);

/// Returns the lower boundary of one part at x; +infinity where the part is not above x.
double lowerBoundary(const TaperedHull& hull, double x);
double lowerBoundary(const std::vector<Vec2>& polygon, double x);

/// Returns the lower envelope of the whole robot: the least of the parts' lower boundaries.
double lowerEnvelope(const RobotShape& shape, double x);

/// Returns the sign of a tip-up rotation as a rotation x → z: front positive, rear mirrored.
double turnSign(const FlipperGeometry& flipper);

/// Returns a point on a flipper's lower edge at this joint angle, pose's frame. share: from the
/// pivot end (0) to the tip end (1).
Vec2 edgePoint(const FlipperGeometry& flipper, double angle, const Pose& pose, double share);

/// Returns a point on the front flippers' lower edge, pose's frame. share: from the pivot end (0)
/// to the tip end (1), such as RobotModel::elementShare.
Vec2 elementPosition(const RobotModel& robot, const Pose& pose, double share);

}  // namespace terratact
