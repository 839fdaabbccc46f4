#pragma once

#include <limits>
#include <vector>

#include "core/robot/robot_model.h"

namespace terratact {

/// Where the robot is: base origin in a frame along gravity, pitch (nose up) and flipper angles.
struct Pose {
    Vec2 base;           ///< [m]
    double pitch = 0.0;  ///< [rad] nose up positive
    double front = 0.0;  ///< [rad] tip up positive
    double rear = 0.0;   ///< [rad] tip up positive
};

/// Rotates by `angle` [rad], x towards z.
Vec2 rotated(Vec2 v, double angle);

/// Base frame → the pose's frame.
Vec2 toWorld(const Pose& pose, Vec2 pointInBase);

/// The IMU in the pose's frame: the origin of the DEM frame.
Vec2 imuPosition(const RobotModel& robot, const Pose& pose);

/// What the tracks roll off between two poses close to each other [m], forward positive: the part of the base's
/// way along them, at the mean of the two pitches.
double trackWay(const Pose& from, const Pose& to);

/// The pose whose frame is the DEM frame: origin at the IMU, axes along gravity.
Pose poseInDem(const RobotModel& robot, double pitch, double front, double rear);

/// Unit vector from a flipper's pivot to its tip circle, base frame:
///   front (cos(θ − taper), sin(θ − taper)), rear mirrored in x.
Vec2 flipperAxis(const FlipperGeometry& flipper, double angle);

/// The robot's parts as convex shapes in the pose's frame.
struct RobotShape {
    TaperedHull track, front, rear;
    std::vector<std::vector<Vec2>> body;  ///< convex polygons
};
RobotShape shapeAt(const RobotModel& robot, const Pose& pose);

/// No point of the robot is further from its base's origin than this [m], whatever its flippers' angles.
double reachOf(const RobotModel& robot);

/// Lower boundary of one part over x; +infinity where the part is not above x.
double lowerBoundary(const TaperedHull& hull, double x);
double lowerBoundary(const std::vector<Vec2>& polygon, double x);

/// Lower envelope of the whole robot: the least of the parts' lower boundaries.
double lowerEnvelope(const RobotShape& shape, double x);

/// Position of force element 1 … 6 (index 0 … 5) on the front flippers' lower edge, pose's frame.
Vec2 elementPosition(const RobotModel& robot, const Pose& pose, double share);

}  // namespace terratact
