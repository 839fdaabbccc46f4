#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/robot/force_sensor.h"

namespace terratact {

/// One line of a calibration recording: a known force on one element's sandwich.
struct ForceReading {
    Side side = Side::Left;
    int element = 0;       ///< 0 … 5
    double applied = 0.0;  ///< [N] in addition to the sandwich's own force; 0: unloaded
    double voltage = 0.0;  ///< [V] on the reference resistor
};

struct FittedCalibration {
    ForceCalibration calibration;
    double medianError = 0.0;  ///< median error of the readings with this calibration [N]
    double worstError = 0.0;   ///< [N]
};

/// Fits bias and curve of the elements that the arrays have; other elements keep their bias. The
/// bias of an element is the force of its median unloaded reading. If forces were applied, a new
/// curve gets one point per applied force. It has that force plus the mean bias, and the median
/// resistance of all elements. Unloaded readings give its first point. Without applied forces the
/// present curve stays. Supply, reference and thresholds stay. Errors: a reading of an element that
/// no array has, or that is broken or shorted; an element without unloaded readings. A curve whose
/// resistance does not fall is also an error. Throws std::invalid_argument for an element that does
/// not exist, or an invalid force.
Result<FittedCalibration> calibrate(const std::vector<ForceReading>& readings,
                                    const ForceCalibration& present,
                                    const std::vector<ForceArrayLayout>& arrays);

}  // namespace terratact
