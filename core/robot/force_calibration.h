#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/robot/force_sensor.h"

namespace terratact {

/// One line of a recording: a known force was laid on an element's sandwich.
struct ForceReading {
    Side side = Side::Left;
    int element = 0;       ///< 0 … 5
    double applied = 0.0;  ///< [N] beyond the sandwich's own; 0: nothing on it
    double voltage = 0.0;  ///< [V] on the reference resistor
};

struct FittedCalibration {
    ForceCalibration calibration;
    double medianError = 0.0;  ///< [N] of the readings, by this calibration
    double worstError = 0.0;   ///< [N]
};

/// Learns bias and curve of the elements that the arrays have; the others' bias stays.  An element's bias is
/// what its unloaded readings (their median) mean on the present curve.  Where forces were applied, a new
/// curve goes through one point per applied force: that force and the mean bias over the median resistance
/// of all elements; unloaded readings make its first point.  Without them the present curve stays.  Supply,
/// reference and thresholds stay as they are.
/// Errors: a reading of an element that no array has; an element without unloaded readings; a reading of a
/// broken or shorted element; a curve whose resistance does not fall.  Throws std::invalid_argument for an
/// element or a force that is none.
Result<FittedCalibration> calibrate(const std::vector<ForceReading>& readings,
                                    const ForceCalibration& present,
                                    const std::vector<ForceArrayLayout>& arrays);

}  // namespace terratact
