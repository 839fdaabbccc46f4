#pragma once

#include <array>
#include <vector>

#include "core/infer/estimate/settings.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {

/// Returns the contacts of the front flippers, left and right, from the readings of one scene alone
/// (core/terrain/kinematic_reconstruction.h). Of one plane, they are those of the plane, at the left. settings: force
/// threshold and contact rule.
std::array<std::vector<Contact>, 2> sceneContacts(const RobotModel& robot, const Measurement& scene,
                                                  bool onePlane, const Settings& settings);

}  // namespace terratact
