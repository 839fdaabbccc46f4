#pragma once

#include <vector>

#include "app/modelling/evaluation/scene_evaluation.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Prints the effect of missing sensors on options.methods, and writes it as missing.csv into options.out. The cases
/// are: nothing missing, one current, all currents, one force element, all forces, and all of these. The columns are
/// |error|, and coverage and width of the 80 % band. A single missing array is not a case, because the other array
/// replaces its forces.
Status printMissingSensors(const std::vector<Scene>& scenes, const EstimatorBundle& bundle,
                           const EvaluateOptions& options);

}  // namespace terratact
