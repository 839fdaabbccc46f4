#pragma once

#include <vector>

#include "app/modelling/evaluation/scene_evaluation.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Prints the effect of missing sensors on options.methods, and writes it as missing.csv into options.out. The cases
/// are: nothing missing, one current, all currents, one force element, the right array, all forces, and all of these.
/// The columns are |error|, and coverage and width of the 80 % band. A scene of one plane has the mean of both arrays.
/// Without the right array the left one counts alone: sidesOf() draws its forces, with options.settings.seed.
Status printMissingSensors(const std::vector<Scene>& scenes, const EstimatorBundle& bundle,
                           const EvaluateOptions& options);

}  // namespace terratact
