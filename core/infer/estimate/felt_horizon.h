#pragma once

#include <optional>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// The foremost loaded element may lie this far behind a bin's front border [m].
inline constexpr double kHorizonSlack = 0.01;

/// Returns true if the estimate tells how each of its bins was touched.
bool isTouchRecorded(const TerrainEstimate& estimate);

/// Returns the last bin ahead that is felt, now or earlier, or lies behind a loaded element;
/// kFirstAhead − 1: none.
/// Where the touch is not recorded, it is the last bin.
int horizonBin(const TerrainEstimate& estimate);

/// Returns the front border of that bin [m]; empty if nothing ahead is felt, or the touch is not
/// recorded.
std::optional<double> feltHorizon(const TerrainEstimate& estimate);

}  // namespace terratact
