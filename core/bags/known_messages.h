#pragma once

#include <string_view>

namespace terratact {

/// Returns the ROS 2 definition of a common message type, with those of its parts; empty for another
/// type. Files of rosbag2 before ROS Iron hold no definitions. The types: sensor_msgs JointState and
/// Imu, nav_msgs Odometry, geometry_msgs TwistStamped, std_msgs Float64, Float32, Float64MultiArray and
/// Float32MultiArray, tf2_msgs TFMessage.
std::string_view knownDefinition(std::string_view type);

}  // namespace terratact
