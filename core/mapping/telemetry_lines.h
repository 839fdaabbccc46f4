#pragma once

#include <vector>

#include "core/mapping/mapping.h"
#include "core/mapping/recorded_series.h"
#include "core/mapping/standing_presses.h"

namespace terratact {

/// Joins series to lines of telemetry. There is a line for each measured pitch, or Mapping::rate lines
/// per second. At a line's time a value is interpolated between neighbours that are at most
/// Mapping::maxGap apart. Angles are interpolated along the shorter way. The last value holds for
/// maxGap. Otherwise it was not measured. A line without pitch or a flipper angle is left out. A
/// missing roll is 0. Activity and refusal hold until their next message. Without them, the rule
/// `scenes` decides which lines are presses. Of the others, those with motion are drives and the rest
/// halts.
std::vector<TelemetryLine> telemetryLines(const RecordedSeries& series, const Mapping& mapping);

}  // namespace terratact
