#pragma once

#include <string>

#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A robot file as it was read once: what is used, shown and recorded are the same bytes.
struct RobotFile {
    std::string path, text;
    std::string hash;  ///< SHA-256 of the text, 64 hexadecimal digits
    RobotModel model;
};

/// Errors as readRobotModel().
Result<RobotFile> readRobotFile(const std::string& path);

}  // namespace terratact
