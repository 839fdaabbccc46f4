#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mapping/recorded_series.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Returns warnings about a recording under a mapping, one sentence each:
///   - gaps of more than Mapping::maxGap in a topic;
///   - topics whose header.stamp has an offset of more than 1 s from the recorder's time;
///   - topics whose offsets differ by more than 0.1 s;
///   - angles beyond a full turn (a pitch or roll beyond a quarter or half turn): degrees taken for
///     radians; degrees that never leave ±3.2: radians taken for degrees;
///   - a sensor that never changes while another one does: stuck;
///   - a current or force of which at least 2 % and 20 values equal its largest one: saturated.
/// watch: called with each message. Errors are those of readSeries().
Result<std::vector<std::string>> checkRecording(const std::string& path, const Mapping& mapping,
                                                const RobotModel& robot,
                                                const RecordingWatch& watch = {});

/// Returns the warnings that make the numbers of an import wrong: units of angles, and clocks that
/// differ from the recorder's.
std::vector<std::string> importWarnings(const RecordedSeries& series, const Mapping& mapping);

}  // namespace terratact
