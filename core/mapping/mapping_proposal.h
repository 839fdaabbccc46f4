#pragma once

#include <string>
#include <vector>

#include "core/mapping/recording_survey.h"

namespace terratact {

/// Returns a mapping file (TOML) for the topics of a recording. It has a comment for each guess and
/// for what was not found. Fields that have the name of a quantity are guessed, and a topic of frames.
/// sensor_msgs/Imu is taken as attitude, nav_msgs/Odometry and geometry_msgs/TwistStamped as odometry.
/// Joints of sensor_msgs/JointState are guessed by their names. Names contain "front", "rear" or "back", and "left" or
/// "right", or one of fl, fr, rl, rr. name: of the mapping.
std::string proposedMapping(const std::vector<TopicSurvey>& topics, const std::string& name);

}  // namespace terratact
