#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A number of a robot file that disagrees with others.
struct RobotFinding {
    enum class Level {
        Remark,   ///< unusual: look at it
        Problem,  ///< cannot be
    };
    Level level = Level::Remark;
    std::string key;   ///< "front_flipper.axle_distance_m"
    std::string text;  ///< what it is, what was expected and what to do
};

/// Checks that the numbers of a robot agree. The lower edges of tracks, flippers and body must fit a
/// flat floor, and the flippers' lengths each other. The centre of mass must lie within the support.
/// Torques are compared with weights. The range of the force elements and the positions of IMU, arm
/// and sides are checked. Findings come in the order of the file.
std::vector<RobotFinding> checkRobot(const RobotModel& robot);

/// Result of a check of a file.
struct RobotCheck {
    RobotModel robot;
    std::vector<RobotFinding> findings;  ///< text begins with the line and the key
    std::size_t problems() const;
};

/// Reads a robot file and checks it. A file without [lateral] gets a remark. Errors are those of readRobotModel().
Result<RobotCheck> checkRobotFile(const std::string& path);

}  // namespace terratact
