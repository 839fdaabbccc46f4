#pragma once

#include <string>

#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A robot file, read once, so that the same bytes are used, shown and recorded.
struct RobotFile {
    std::string path, text;
    std::string hash;  ///< SHA-256 of the text, 64 hexadecimal digits
    RobotModel model;
};

/// Returns the errors of readRobotModel().
Result<RobotFile> readRobotFile(const std::string& path);

}  // namespace terratact
