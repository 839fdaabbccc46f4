#pragma once

#include <array>
#include <functional>
#include <memory>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/touch.h"
#include "core/infer/sampling/conditionals.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/gp/gaussian_process.h"

namespace terratact {

/// A sampling method at one scene: the sampler's problem and the estimate that its draws complete.
struct SceneSampling {
    TerrainEstimate estimate;  ///< all but the drawn bins, whose origin is set
    GibbsProblem problem;
    std::unique_ptr<const Conditionals> conditionals;
    OptionalHeights known;  ///< heights [m] of the bins that are not drawn
    Centre centre = Centre::Mean;
    PressedBins pressed;  ///< touch of the bins by the force elements
    /// Returns the Gaussian process that predicts a drawn bin.
    std::function<const GaussianProcess&(int bin)> process;
};

/// Returns the estimate from the draws of sampling.problem. Throws std::invalid_argument if it is
/// not finite. Throws Cancelled.
TerrainEstimate estimateFrom(SceneSampling sampling, const GibbsDraws& draws,
                             const Watch& watch = {});

/// Samples the scene and returns its estimate.
TerrainEstimate sampleScene(SceneSampling sampling, const Watch& watch = {});

}  // namespace terratact
