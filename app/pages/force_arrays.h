#pragma once

#include <optional>
#include <vector>

#include "core/robot/force_drift.h"
#include "core/robot/robot_model.h"
#include "core/wire/telemetry.h"
#include "widgets/signals/force_bars.h"

namespace terratact {

/// The arrays of a robot as ForceBars shows them.  Follows the drift of each while nothing presses on it.
class ForceArrays {
public:
    explicit ForceArrays(const RobotModel& robot) : robot_(robot) {}

    /// Those of the robot's file, where a line of the bus says what each feels; else one array that feels the
    /// measured forces, without voltages.  `threshold` [N] of contact.
    std::vector<ForceArray> of(const Measurement& measurement,
                               const std::optional<SensorLine>& line, double threshold);

private:
    ForceArray arrayOf(const ForceArrayLayout& layout, const SensorLine& line,
                       const ElementForces& felt, ForceDrift::Forces& beyondBias) const;

    RobotModel robot_;
    std::vector<ForceDrift> drifts_;
};

}  // namespace terratact
