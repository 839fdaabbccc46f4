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

/// A sampling method at one scene: what the sampler is asked, and what its draws are made of.
struct SceneSampling {
    TerrainEstimate estimate;  ///< without the bins that are drawn; their origin is set
    GibbsProblem problem;
    std::unique_ptr<const Conditionals> conditionals;
    OptionalHeights known;  ///< [m] of the bins that are not drawn
    Centre centre = Centre::Mean;
    PressedBins pressed;  ///< what the force elements say
    /// What predicts a bin that is drawn.
    std::function<const GaussianProcess&(int bin)> process;
};

/// The estimate from the draws of sampling.problem.
/// Throws std::invalid_argument where it is not finite; Cancelled.
TerrainEstimate estimateFrom(SceneSampling sampling, const GibbsDraws& draws,
                             const Watch& watch = {});

/// Samples, and the estimate.
TerrainEstimate sampleScene(SceneSampling sampling, const Watch& watch = {});

}  // namespace terratact
