#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/standing_presses.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A pose in which the robot stood still: means over its lines. A current that one of them lacks is
/// missing.
struct StandingPose {
    Measurement mean{};
    double pitchSd = 0.0, rollSd = 0.0;  ///< [rad] of the means
    std::size_t lines = 0;
};

/// Returns the poses in which the robot stood still for at least half a second, in the order of time. A pose ends when
/// pitch, roll or a flipper angle leaves its mean by 0.02 rad for half a second.
std::vector<StandingPose> standingPoses(const std::vector<TelemetryLine>& lines);

/// Reads the standing poses of sessions. Errors name the file.
Result<std::vector<StandingPose>> standingPosesOf(const std::vector<std::string>& sessions,
                                                  const RobotModel& robot);

}  // namespace terratact
