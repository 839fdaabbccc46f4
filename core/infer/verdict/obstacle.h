#pragma once

#include <array>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/terrain/step.h"

namespace terratact {

/// Probability of a step of more than a limit, and how well the draws know it.
struct StepProbability {
    double p = 0.0;
    double monteCarloSd = 0.0;  ///< of p, never 0
    bool operator==(const StepProbability&) const = default;
};

/// Share p of draws with a step (hasStep) of more than `limit` within firstBin … lastBin,
///   p = #{d : max |h_j − h_i| > limit over 0 < j − i ≤ kStepBins} / n,   monteCarloSd = √(p (1 − p) / n_eff).
/// limit: [m].  effectiveDraws: n_eff, independent draws that say as much as these n.
/// Where p is 0 or 1 the sd takes (k + 1)/(n_eff + 2) with k = 0 or n_eff in p's place: no number of
/// draws makes certain.
/// Throws std::invalid_argument for no draws, a limit below 0 or not finite, effectiveDraws not in
/// 1 … draws.size(), or unless 0 ≤ firstBin < lastBin ≤ 10.
/// Source: Laplace's rule of succession.
StepProbability stepProbability(const std::vector<Heights>& draws, double limit, int firstBin,
                                int lastBin, double effectiveDraws);

/// The least ess of the sampled bins, within 1 … draws.size(): what a joint question may count on.
/// draws.size() where no bin was sampled.  Throws std::invalid_argument for an estimate without draws.
double effectiveDraws(const TerrainEstimate& estimate);

/// Within every pair of neighbours, the rear one's index first. The probability of a pair whose front bin is not felt
/// is at least its rate of hazards (unfeltStepRate). Throws as stepProbability does.
std::array<StepProbability, kBins - 1> stepProbabilities(const TerrainEstimate& estimate,
                                                         double limit);

/// Within firstBin … lastBin, at least unfeltStepRate(estimate, firstBin, lastBin). Throws as stepProbability does.
StepProbability anyStep(const TerrainEstimate& estimate, double limit, int firstBin = 0,
                        int lastBin = kBins - 1);

}  // namespace terratact
