#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Height of a bin that a force element or the arm touched.
struct MeasuredHeight {
    double height = 0.0;  ///< [m]
    double sd = 0.0;      ///< [m]
    Origin origin = Origin::Contact;
};

struct MeasuredBins {
    /// The arm's reading where both touched it.
    std::array<std::optional<MeasuredHeight>, kBins> bin{};
    /// Readings that contradict the robot's body, and contacts and arm readings that contradict
    /// each other.
    std::vector<Message> warnings;
};

/// Returns the contacts of the flippers and the readings of the arm. Methods without forces have no
/// contacts, nor has ContactRule::None. A reading of the arm replaces the contact of its bin.
/// ceiling: of this pose [m]. A reading more than 3 sd above it is kept and named in `warnings`.
/// Throws std::invalid_argument unless every reading has a bin 0 … 10, a finite height and a
/// positive sd.
MeasuredBins measureBins(const RobotModel& robot, const Proprioception& s,
                         std::span<const ArmReading> arm, const Heights& ceiling,
                         const Settings& settings);

}  // namespace terratact
