#pragma once

#include <vector>

#include "app/cli/commands.h"
#include "app/modelling/scene_estimates.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Prints, and writes as missing.csv into options.out, what options.methods err on the scenes with everything measured, and where one current, all currents, one
/// force element, all forces or all of them were not measured: |error|, coverage of the 80 % band and its width.
/// One array alone, left or right, is not among them: forces are then those of the other one, and nothing lacks.
Status printMissingSensors(const std::vector<Scene>& scenes, const EstimatorBundle& bundle,
                           const EvaluateOptions& options);

}  // namespace terratact
