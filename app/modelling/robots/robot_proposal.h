#pragma once

#include <string>
#include <vector>

#include "app/modelling/robots/robot_calibration.h"
#include "core/base/result.h"

namespace terratact {

/// Returns the calibration in lines for a person. Each number stands beside the file's, with its
/// sd. Further lines say what the recordings do not identify, what would, and what no standing poses
/// identify.
std::vector<std::string> calibrationReport(const RobotCalibration& calibration,
                                           const RobotModel& robot);

/// Returns the text of a robot file with the identified numbers in place of the old ones. Each has
/// a comment. `name` is for errors: a number stands on no line of its own.
Result<std::string> proposedRobotFile(const std::string& name, const std::string& text,
                                      const RobotCalibration& calibration);

}  // namespace terratact
