#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/plotting/plot_signal.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Returns the signals of a line of telemetry: attitude, flippers, currents, forces, way. Their order is fixed. The
/// forces of each side follow behind kEverySignals.
std::span<const PlotSignal> telemetrySignals();
inline constexpr std::size_t kEverySignals = 19;
/// The first ones of them are of sensors that every robot has; of the others, a robot may have none.
inline constexpr std::size_t kSensorSignals = 16;

/// Returns the value of telemetrySignals()[index]; empty: not measured. Throws std::out_of_range for another index.
std::optional<double> telemetryValue(std::size_t index, const Measurement& measurement);

}  // namespace terratact
