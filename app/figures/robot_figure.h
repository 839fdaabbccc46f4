#pragma once

#include <string>

#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Draws the numbers of a robot file: side view on a flat floor and view from above. Flippers are at angle
/// 0 and, dashed, raised by 0.7 rad. Force elements, centres of mass, the IMU with its bins, and the arm's
/// reach are marked. The file is PNG, SVG or PDF by its ending, written under a temporary name and renamed.
/// Errors name the file.
Status writeRobotFigure(const std::string& path, const RobotModel& robot);

}  // namespace terratact
