#pragma once

#include "core/base/poll.h"
#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Sizes of the hazards that nobody has felt [m].
inline constexpr double kSmallestHazard = 0.15;
inline constexpr double kLargestHazard = 2.0;

/// Mixes rare hazards into the bins ahead (from kFirstAhead on) that are Bounded or NotFelt.
/// With probability `rate` a hazard begins in such a bin. Its offset lasts until the next bin that is felt:
///   height' = height + Σ offsets begun since the last felt bin,   |offset| log-uniform in
///   [kSmallestHazard, kLargestHazard],
/// a drop in a Bounded bin, a drop or a wall with equal chance in a NotFelt bin. A Bounded height stays at or below
/// its ceiling. Exactly ⌈rate · n⌉ of n draws get a hazard in each bin. Mean, sd and quantiles of these bins are then those
/// of the draws; `height` stays the model's own. Felt bins stay as they are, bit for bit.
///   rate: 0 … 1; 0 changes nothing.    Throws std::invalid_argument for another rate.
/// The draws of settings.seed decide: the same estimate gives the same result.
void addHazards(TerrainEstimate& estimate, double rate, const Poll& poll = {});

/// Least P(a step) within bins firstBin … lastBin: 1 − (1 − rate)^n, n the bins from kFirstAhead on which are not Felt;
/// 0 where the touch is not recorded.  rate: settings.hazardRate.
double unfeltStepRate(const TerrainEstimate& estimate, int firstBin, int lastBin);

}  // namespace terratact
