#pragma once

#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Estimates as CSV, one row per scene and bin:
///   run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note,height_m,p_step,
///   p_step_sd,two_modes,novelty,draws,ending,touch,horizon_m,verdict
/// height_m: the one number to show; p_step: probability that this bin and the next differ by more than
/// kStepLimit, with its Monte-Carlo error; two_modes: 1 where the draws fall into two heaps;
/// draws, ending: how many there are and why there are no more (Ending).
/// Empty: no estimate (the note says why), no ceiling, unknown truth.  The note is the result's warnings.
/// scenes and estimates: of the same size, else std::invalid_argument.
std::string estimateCsv(const std::vector<Scene>& scenes,
                        const std::vector<SceneEstimate>& estimates);

}  // namespace terratact
