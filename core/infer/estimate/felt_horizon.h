#pragma once

#include <optional>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// The foremost loaded element may lie this far behind a bin's front border [m].
inline constexpr double kHorizonSlack = 0.01;

/// Returns true if the estimate records how each of its bins was touched.
bool isTouchRecorded(const TerrainEstimate& estimate);

/// Returns the last bin ahead that is felt, now or earlier, or lies behind a loaded element;
/// kFirstAhead − 1: none. Bins before it may be bounded, or felt in part.
/// Where the touch is not recorded, it is the last bin.
int horizonBin(const TerrainEstimate& estimate);

/// Returns the last bin ahead up to which every bin is felt, now or earlier; kFirstAhead − 1: the
/// first one is not. Where the touch is not recorded, it is the last bin.
int lastFeltBin(const TerrainEstimate& estimate);

/// Returns the front border of lastFeltBin() [m]. Empty: the first bin ahead is not felt, or the
/// touch is not recorded.
std::optional<double> feltHorizon(const TerrainEstimate& estimate);

}  // namespace terratact
