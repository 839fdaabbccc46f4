#pragma once

#include <span>

#include "core/base/poll.h"
#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Range of the depth or height of a hazard [m], here and on simulated ground
/// (core/sim/ground/hazard_terrain.h).
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

/// A hazard that a reading of the arm may have found: the model expects other ground there.
struct MeasuredHazard {
    int bin = 0;
    double height = 0.0, sd = 0.0;  ///< [m] the reading
    double offset = 0.0;            ///< [m] from the model's median to the reading
    double probability = 0.0;       ///< P(hazard | reading)
};

/// Returns P(hazard | reading) by Bayes' rule:
///   p = r H / (r H + (1 − r) M),   r = max(rate, kMinHazardRate)
/// M is the model's density of the reading. H is the density of a hazard of the sizes of addHazards():
///   H = ½ Φ((|offset| − kSmallestHazard) / sd) / (max(|offset|, kSmallestHazard) ln(largest / smallest))
/// Below a finite ceiling, a hazard is a drop for certain: without the ½, and 0 for a rise.
/// logDensity: ln M, M per metre. rate: 0 … 1.
double hazardProbability(double offset, double sd, double logDensity, bool isCovered, double rate);

/// Least rate in hazardProbability(): a reading far from the model indicates a hazard even at rate 0.
inline constexpr double kMinHazardRate = 0.001;

/// Mixes the hazards that the arm found into their bins: a share `probability` of the draws gets the
/// reading with its error. Bins ahead of it move by `offset` in these draws, up to the next one that
/// is felt or measured. Mean, sd, quantiles and height of these bins are then computed from the
/// draws. A probability that is less than half a draw changes nothing. Random numbers as for
/// addHazards(). The touch must be known.
void addMeasuredHazards(TerrainEstimate& estimate, std::span<const MeasuredHazard> hazards,
                        const Poll& poll = {});

/// Returns the lower bound of P(a step) within bins firstBin … lastBin: 1 − (1 − rate)^n. n counts
/// the bins from kFirstAhead on that are neither Felt nor Remembered, and rate is
/// settings.hazardRate. Returns 0 where the touch is not recorded.
double unfeltStepRate(const TerrainEstimate& estimate, int firstBin, int lastBin);

}  // namespace terratact
