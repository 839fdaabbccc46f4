#pragma once

#include <optional>
#include <vector>

#include "core/robot/force_drift.h"
#include "core/robot/robot_model.h"
#include "core/wire/telemetry.h"
#include "widgets/signals/force_bars.h"

namespace terratact {

/// Returns a left and a right array with the measured forces of the rear flippers, without voltages.
std::vector<ForceArray> rearArraysOf(const Measurement& measurement);

/// Converts forces for ForceBars, per array of the robot. It tracks the bias drift of each element while nothing
/// presses on it.
class ForceArrays {
public:
    explicit ForceArrays(const RobotModel& robot) : robot_(robot) {}

    /// Returns the arrays of the robot file, if a sensor line of the bus has their forces. Otherwise returns one array
    /// with the measured forces, without voltages. threshold: contact threshold [N].
    std::vector<ForceArray> of(const Measurement& measurement, const ElementForces& felt,
                               double threshold);

private:
    ForceArray arrayOf(const ForceArrayLayout& layout, const ElementForces& felt,
                       ForceDrift::Forces& beyondBias) const;

    RobotModel robot_;
    std::vector<ForceDrift> drifts_;
};

}  // namespace terratact
