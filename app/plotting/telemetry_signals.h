#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/plotting/plot_signal.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Returns the signals of a line of telemetry: attitude, flippers, currents, forces, way. Their order is fixed. The
/// first ones, up to kEverySignals, exist for every robot; the forces of each side follow.
std::span<const PlotSignal> telemetrySignals();
inline constexpr std::size_t kEverySignals = 19;

/// Returns the value of telemetrySignals()[index]; empty: not measured. Throws std::out_of_range for another index.
std::optional<double> telemetryValue(std::size_t index, const Measurement& measurement);

}  // namespace terratact
