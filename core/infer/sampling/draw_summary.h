#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/gibbs.h"

namespace terratact {

/// Statistic of a bin's draws that is shown as its height.
enum class Centre : std::uint8_t { Mean, Median };

/// Writes one bin of an estimate from its draws: mean, sd, quantiles, the height to show, R-hat and
/// ESS. RankedDraws gets the bin's ceiling as its bound.
/// draws: kept sweeps × chains, heights [m]. poll: called during the work, here and below.
void summariseDraws(TerrainEstimate& estimate, int bin, const Eigen::MatrixXd& draws, Origin origin,
                    Centre centre, const Poll& poll = {});

/// Writes a bin that was not sampled: the measured height and the quantiles of a Gaussian around
/// it.
void fixBin(TerrainEstimate& estimate, int bin, const MeasuredHeight& measured);

/// Adds a warning if the bin's model needed a jitter.
void warnIfMended(TerrainEstimate& estimate, int bin, const GaussianProcess& model);

/// Returns the draws of all chains, one chain after the other. Known bins keep their heights.
std::vector<Heights> jointDraws(const GibbsDraws& draws, const OptionalHeights& known,
                                const Poll& poll = {});

/// Completes an estimate whose bins are all written: joint draws, ending, and the known bins' ESS.
/// `converged` follows from the worst R-hat and ESS of the sampled bins; a warning is added if it
/// is false.
///   known: heights [m]
void conclude(TerrainEstimate& estimate, const GibbsDraws& draws, const OptionalHeights& known,
              const Poll& poll = {});

/// Returns the estimate unchanged. Throws RefusedInput unless every number is finite that
/// must be (TerrainEstimate). A model with finite but absurd numbers may give such an estimate.
TerrainEstimate finite(TerrainEstimate estimate, const Poll& poll = {});

}  // namespace terratact
