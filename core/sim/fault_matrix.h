#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/sim/sensor_fault.h"

namespace terratact {

/// One kind of fault at one sensor.
struct MatrixCell {
    std::string sensor;       ///< as sensorFaultFrom() reads it
    std::string_view kind;    ///< likewise
    std::string fault;        ///< both, with an amount
    std::string_view reason;  ///< why SensorWatch cannot notice it in most drives; empty: it does
};

/// Stuck, drift, spikes, flipped, swapped, late, out of range: the columns.
std::vector<std::string_view> matrixKinds();

/// Each of them at each sensor, sensor by sensor: attitude, four angles, four currents, six forces, the twelve elements
/// they are the means of, odometry.
std::vector<MatrixCell> faultMatrix();

}  // namespace terratact
