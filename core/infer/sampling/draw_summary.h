#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/gibbs.h"

namespace terratact {

/// Which number of a bin's draws is the one to show.
enum class Centre : std::uint8_t { Mean, Median };

/// Writes one bin of an estimate from its draws: mean, sd, quantiles, the height to show, R-hat and ESS (RankedDraws,
/// the bin's ceiling being the bound).
/// draws: kept sweeps × chains, heights [m].  poll: here and below, in the course of it.
void summariseDraws(TerrainEstimate& estimate, int bin, const Eigen::MatrixXd& draws, Origin origin,
                    Centre centre, const Poll& poll = {});

/// Writes a bin that was not sampled: the measured height, and a Gaussian's quantiles about it.
void fixBin(TerrainEstimate& estimate, int bin, const MeasuredHeight& measured);

/// Warns where the bin's model needed a jitter.
void warnIfMended(TerrainEstimate& estimate, int bin, const GaussianProcess& model);

/// The chains' draws one after the other; known bins stand still at their heights.
std::vector<Heights> jointDraws(const GibbsDraws& draws, const OptionalHeights& known,
                                const Poll& poll = {});

/// How sampling ended, for an estimate whose bins are all written: joint draws, ending, the known bins' ESS, and
/// `converged` by the worst R-hat and ESS of the sampled bins, with a warning where it is not.
///   known: heights [m]
void conclude(TerrainEstimate& estimate, const GibbsDraws& draws, const OptionalHeights& known,
              const Poll& poll = {});

/// The estimate.  Throws std::invalid_argument unless every number is finite that has to be (TerrainEstimate): a model
/// whose numbers are finite, but absurd, may leave a scene without one.
TerrainEstimate finite(TerrainEstimate estimate, const Poll& poll = {});

}  // namespace terratact
