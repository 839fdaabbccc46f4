#pragma once

#include <vector>

#include "core/mapping/mapping.h"
#include "core/mapping/recorded_series.h"
#include "core/mapping/standing_presses.h"

namespace terratact {

/// Joins series to lines of telemetry. There is a line for each measured pitch, or Mapping::rate lines
/// per second. At a line's time a value is interpolated between neighbours that are at most
/// Mapping::maxGap apart. Angles are interpolated along the shorter way. Behind the last value it holds
/// for maxGap. Elsewhere it was not measured; a line without pitch or a flipper angle is left out.
/// Without a roll it is 0. Activity and refusal hold until their next message. Without them the robot
/// pressed where the rule `scenes` says so, else it drove where it moved, and halted elsewhere.
std::vector<TelemetryLine> telemetryLines(const RecordedSeries& series, const Mapping& mapping);

}  // namespace terratact
