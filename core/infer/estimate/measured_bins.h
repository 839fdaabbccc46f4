#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// The height of a bin that something touched.
struct MeasuredHeight {
    double height = 0.0;  ///< [m]
    double sd = 0.0;      ///< [m]
    Origin origin = Origin::Contact;
};

/// A height that something else than touch at this pose speaks for, such as the last estimate (ghost.h).
struct WeakHeight {
    double height = 0.0;  ///< [m]
    double sd = 0.0;      ///< [m]
    bool operator==(const WeakHeight&) const = default;
};
using WeakHeights = std::array<std::optional<WeakHeight>, kBins>;

struct MeasuredBins {
    std::array<std::optional<MeasuredHeight>, kBins> bin{};  ///< the arm's where both touched it
    std::vector<std::string> warnings;                       ///< what contradicts the robot's body,
                                                             ///< or contact and arm each other
};

/// Contacts of the flipper (for methods that use forces) and readings of the arm.
///   ceiling: of this pose [m]; a reading more than 3 sd above it is kept and named in `warnings`.
///   weak: taken where nothing touched the bin, which stays Origin::Sampled.
/// Throws std::invalid_argument for a reading without a bin 0 to 10, and for any without a finite height and a
/// positive sd.
MeasuredBins measureBins(const RobotModel& robot, const Proprioception& s,
                         std::span<const ArmReading> arm, const Heights& ceiling,
                         const Settings& settings, const WeakHeights& weak = {});

}  // namespace terratact
