#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/base/result.h"
#include "core/eval/tradeoff.h"

namespace terratact {

/// Returns the scenes of a file that have every feature of s and every true height. Errors: those of the file; no scene
/// has them.
Result<std::vector<Scene>> tradeoffScenes(const std::string& path);

/// Cost and errors of one method.
struct MethodTradeoff {
    std::vector<TradePoint> points;  ///< of tradeSettings(); none of a setting without any estimate
    ReferenceQuality reference;      ///< of the long reference runs
};

/// Measures every setting of the method (core/eval/tradeoff.h) on the scenes. The reference runs of referenceDraws
/// draws are computed on all cores. Each setting is then timed in this thread, scene after scene, by its processor
/// time. A scene without a reference run does not count. Of a method that simulates the arm, the second estimate is
/// timed. Scene k uses seed + k; the reference runs use other seeds.
MethodTradeoff measureTradeoff(Method method, const std::vector<Scene>& scenes,
                               const EstimatorBundle& bundle, int referenceDraws,
                               std::uint64_t seed);

/// Returns a line for the terminal: draws, worst R-hat and effective draws of the reference runs, and their own error.
/// Warnings follow where they are shorter than leastReferenceDraws(), or R-hat exceeds kRhatLimit. Empty for a closed
/// form.
std::string referenceText(const MethodTradeoff& measured);

}  // namespace terratact
