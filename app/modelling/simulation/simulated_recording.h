#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/clouds/pose_track.h"
#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"
#include "core/store/file_group.h"

namespace terratact {

/// A stop of a simulated drive.
struct RecordedStop {
    std::string run;
    CloudPose base;      ///< in the map's frame
    TwoTrackReadings s;  ///< with pressed flippers
};

/// Adds a file of stops to `files`, as a robot with ROS would record them: an MCAP file of JSON messages at 20 Hz with
/// the members of
///   /imu/data       sensor_msgs/Imu: orientation
///   /joint_states   sensor_msgs/JointState: flipper_fl, _fr, _rl, _rr; position [rad], front ones negative upwards;
///                   effort [N m] of one motor, pressing down positive
///   /fsr/left, /fsr/right   data: six forces of the front flipper [N]
///   /map_pose       nav_msgs/Odometry: the base in the map, while the robot stands
/// At each stop the robot stands for 1 s with raised flippers, then for 1.5 s with pressed ones. Before a new run, 60 s
/// pass without a message. resources/mappings/simulated_robot.toml is the mapping.
/// withFloorPoses: behind the stops, the robot holds flipper poses on a flat floor for 2 s each. The flippers are free,
/// then the front, the rear and both of them lift the robot. Then it presses. `terratact robot check` calibrates by
/// them. seed: of the noise of their sensors. Errors name the file.
Status addSimulatedRecording(FileGroup& files, const std::string& path, const RobotModel& robot,
                             const std::vector<RecordedStop>& stops, bool withFloorPoses = false,
                             std::uint64_t seed = 1);

}  // namespace terratact
