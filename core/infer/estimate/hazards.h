#pragma once

#include "core/base/poll.h"
#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Size of a hazard in a bin that is not felt [m].
inline constexpr double kSmallestHazard = 0.15;
inline constexpr double kLargestHazard = 2.0;

/// Mixes rare hazards into the bins ahead (from kFirstAhead on) that are Bounded or NotFelt. With
/// probability `rate` a hazard begins in such a bin. Its offset lasts until the next bin that is
/// felt:
///   height' = height + Σ offsets begun since the last felt bin
///   |offset| is log-uniform in [kSmallestHazard, kLargestHazard].
/// The hazard is a drop in a Bounded bin. In a NotFelt bin it is a drop or a wall with equal
/// chance. A Bounded height stays at or below its ceiling. Exactly ⌈rate · n⌉ of n draws get a
/// hazard in each bin. Mean, sd and quantiles of these bins are then computed from the draws;
/// `height` keeps the model's own value. Felt bins keep every bit.
/// rate: 0 … 1; 0 changes nothing. Throws std::invalid_argument for another rate. settings.seed
/// decides the random numbers: the same estimate gives the same result.
void addHazards(TerrainEstimate& estimate, double rate, const Poll& poll = {});

/// Returns the lower bound of P(a step) within bins firstBin … lastBin: 1 − (1 − rate)^n. n counts
/// the bins from kFirstAhead on that are neither Felt nor Remembered, and rate is
/// settings.hazardRate. Returns 0 where the touch is not recorded.
double unfeltStepRate(const TerrainEstimate& estimate, int firstBin, int lastBin);

}  // namespace terratact
