#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/infer/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// The height of a bin that something touched.
struct MeasuredHeight {
    double height = 0.0;  ///< [m]
    double sd = 0.0;      ///< [m]
    Origin origin = Origin::Contact;
};

struct MeasuredBins {
    std::array<std::optional<MeasuredHeight>, kBins> bin{};  ///< the arm's where both touched it
    std::vector<std::string> warnings;                       ///< what contradicts the robot's body,
                                                             ///< or contact and arm each other
};

/// Contacts of the flipper (for methods that use forces) and readings of the arm.
///   ceiling: of this pose [m]; a reading more than 3 sd above it is kept and named in `warnings`.
/// Throws std::invalid_argument for a reading without a bin 0 to 10, a finite height and a positive sd.
MeasuredBins measureBins(const RobotModel& robot, const Proprioception& s,
                         std::span<const ArmReading> arm, const Heights& ceiling,
                         const Settings& settings);

}  // namespace terratact
