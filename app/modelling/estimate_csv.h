#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Returns estimates as CSV, one row per scene and bin:
///   run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note,height_m,p_step,
///   p_step_sd,two_modes,novelty,draws,ending,touch,horizon_m,verdict
/// height_m: point estimate to show; p_step: probability that this bin and the next differ by more than kStepLimit;
/// p_step_sd: its Monte-Carlo error; two_modes: 1 if the draws are bimodal; draws, ending: number of draws and why
/// sampling ended (Ending); horizon_m: the felt horizon (Verdict::feltTo); note: the result's warnings. An empty field
/// means no estimate (with the reason in the note), no ceiling, or unknown truth. Throws std::invalid_argument unless
/// scenes and estimates have the same size.
std::string estimateCsv(const std::vector<Scene>& scenes,
                        const std::vector<SceneEstimate>& estimates);

/// The header and the rows alone, for a file that is written in parts. The rows throw as above.
std::string estimateCsvHeader();
std::string estimateCsvRows(std::span<const Scene> scenes,
                            std::span<const SceneEstimate> estimates);

}  // namespace terratact
