#pragma once

#include <array>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/terrain/step.h"

namespace terratact {

/// Probability of a step higher than a limit, with its Monte-Carlo error.
struct StepProbability {
    double p = 0.0;
    double monteCarloSd = 0.0;  ///< sd of p, never 0
    bool operator==(const StepProbability&) const = default;
};

/// Returns the share p of draws with a step (hasStep) of more than `limit` within firstBin …
/// lastBin:
///   p = #{d : max |h_j − h_i| > limit over 0 < j − i ≤ kStepBins} / n,
///   monteCarloSd = √(p (1 − p) / n_eff)
/// limit: [m]. effectiveDraws: n_eff, the number of independent draws that hold as much
/// information. If p is 0 or 1, the sd uses (k + 1)/(n_eff + 2) with k = 0 or n_eff for p. No
/// finite number of draws gives certainty. Source: Laplace's rule of succession. Throws
/// std::invalid_argument for no draws, and for a limit below 0 or not finite. It also throws unless
/// 1 ≤ effectiveDraws ≤ draws.size() and 0 ≤ firstBin < lastBin ≤ 10.
StepProbability stepProbability(const std::vector<Heights>& draws, double limit, int firstBin,
                                int lastBin, double effectiveDraws);

/// Returns the effective number of joint draws: the least ess of the sampled bins, within 1 …
/// draws.size(). Returns draws.size() if no bin was sampled. Throws std::invalid_argument for an
/// estimate without draws.
double effectiveDraws(const TerrainEstimate& estimate);

/// Returns the probability of a step within every pair of neighbours; the index is the rear bin's.
/// The probability of a pair whose front bin is not felt is at least the pair's hazard rate
/// (unfeltStepRate). Throws as stepProbability.
std::array<StepProbability, kBins - 1> stepProbabilities(const TerrainEstimate& estimate,
                                                         double limit);

/// Returns the probability of a step within firstBin … lastBin, at least unfeltStepRate(estimate,
/// firstBin, lastBin). Throws as stepProbability.
StepProbability anyStep(const TerrainEstimate& estimate, double limit, int firstBin = 0,
                        int lastBin = kBins - 1);

}  // namespace terratact
