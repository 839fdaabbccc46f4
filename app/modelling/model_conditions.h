#pragma once

#include <string>

#include "core/learn/model/model.h"

namespace terratact {

/// How well conditioned a model's conditionals are, one line for each that is singular, with the jitter that mends it (of
/// its variance) or why it is refused, and the least reciprocal condition number of those that are
/// not.  Factorises them: of 1400 rows
/// some tenths of a second.
std::string conditionsText(const ModelData& model, FeatureSet set);

}  // namespace terratact
