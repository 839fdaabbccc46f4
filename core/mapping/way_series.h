#pragma once

#include <vector>

#include "core/mapping/pose_samples.h"
#include "core/mapping/recorded_series.h"

namespace terratact {

/// Adds Travelled, the way along the base's x axis, and Turned, its heading, at each measured pose.
void addWay(const std::vector<PoseSample>& poses, RecordedSeries& series);

/// Adds Travelled from Speed by the trapezoidal rule. In a gap longer than maxGap [s] the way is not known and stays.
void integrateSpeed(RecordedSeries& series, double maxGap);

}  // namespace terratact
