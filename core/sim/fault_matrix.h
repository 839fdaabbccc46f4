#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/sim/sensor_fault.h"

namespace terratact {

/// Cell of the fault matrix: one kind of fault at one sensor.
struct MatrixCell {
    std::string sensor;       ///< sensor as sensorFaultFrom() reads it
    std::string_view kind;    ///< kind as sensorFaultFrom() reads it
    std::string fault;        ///< sensor and kind, with an amount
    std::string_view reason;  ///< why SensorWatch cannot detect it in most drives; empty: it does
};

/// Returns the columns: stuck, drift, spikes, flipped, swapped, late, out of range.
std::vector<std::string_view> matrixKinds();

/// Returns each kind at each sensor, sensor by sensor. They are attitude, four angles, four
/// currents, six forces on both sides, the twelve elements by themselves, odometry.
std::vector<MatrixCell> faultMatrix();

}  // namespace terratact
