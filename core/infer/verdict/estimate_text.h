#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {

/// Returns one sentence for each fact that a mean and two quantiles hide. The first has the
/// probability and the likeliest place of a step of more than `limit` [m] anywhere ahead. That
/// includes ground beyond the felt horizon. Then comes every bin whose draws fall into two clusters.
/// Empty without draws.
std::vector<Message> hiddenByBands(const TerrainEstimate& estimate, double limit = kStepLimit);

}  // namespace terratact
