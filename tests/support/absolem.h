#pragma once

#include <stdexcept>

#include "core/robot/robot_model.h"

namespace terratact {

/// Returns the shipped robot.
inline RobotModel absolem()
{
    auto robot = readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    if (!robot) throw std::runtime_error(robot.error().text);
    return *robot;
}

}  // namespace terratact
