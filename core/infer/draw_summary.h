#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/infer/estimate.h"
#include "core/infer/gibbs.h"

namespace terratact {

/// Which number of a bin's draws is the one to show.
enum class Centre : std::uint8_t { Mean, Median };

/// Writes one bin of an estimate from its draws: mean, sd, quantiles, the height to show, R-hat and ESS.
/// draws: kept sweeps × chains, heights [m].
void summariseDraws(TerrainEstimate& estimate, int bin, const Eigen::MatrixXd& draws, Origin origin,
                    Centre centre);

/// Warns where the bin's model needed a jitter.
void warnIfMended(TerrainEstimate& estimate, int bin, const GaussianProcess& model);

/// The chains' draws one after the other; known bins stand still at their heights.
std::vector<Heights> jointDraws(const GibbsDraws& draws, const OptionalHeights& known);

/// Sets `converged` by the worst R-hat and ESS of these bins, and warns where it is not.
void judgeConvergence(TerrainEstimate& estimate, const std::vector<int>& bins);

}  // namespace terratact
