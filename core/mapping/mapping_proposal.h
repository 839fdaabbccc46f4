#pragma once

#include <string>
#include <vector>

#include "core/mapping/recording_survey.h"

namespace terratact {

/// Returns a mapping file (TOML) for the topics of a recording, with a comment for each guess and for
/// what was not found. Guessed are: fields that have the name of a quantity; sensor_msgs/Imu as
/// attitude; joints of sensor_msgs/JointState by "front", "rear" or "back", "left" and "right" (also fl,
/// fr, rl, rr) in their names; nav_msgs/Odometry and geometry_msgs/TwistStamped as odometry; a topic of
/// frames. name: of the mapping.
std::string proposedMapping(const std::vector<TopicSurvey>& topics, const std::string& name);

}  // namespace terratact
