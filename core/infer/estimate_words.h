#pragma once

#include <string>
#include <vector>

#include "core/infer/estimate.h"

namespace terratact {

/// Neighbouring bins that differ by more are a step [m]: the height a tracked robot takes without a second
/// thought.
inline constexpr double kStepLimit = 0.10;

/// What a mean and two quantiles hide, one sentence each: the probability of a step of more than `limit` [m]
/// and where it is likeliest, then every bin whose draws fall into two heaps.  Empty without draws.
std::vector<std::string> hiddenByBands(const TerrainEstimate& estimate, double limit = kStepLimit);

}  // namespace terratact
