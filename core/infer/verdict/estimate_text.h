#pragma once

#include <string>
#include <vector>

#include "core/infer/verdict/obstacle.h"

namespace terratact {

/// What a mean and two quantiles hide, one sentence each: the probability of a step ahead of more than `limit`
/// [m] and where it is likeliest, then every bin whose draws fall into two heaps.  Empty without draws.
std::vector<std::string> hiddenByBands(const TerrainEstimate& estimate, double limit = kStepLimit);

}  // namespace terratact
