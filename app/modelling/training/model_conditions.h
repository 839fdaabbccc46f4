#pragma once

#include <string>

#include "core/learn/model/model.h"

namespace terratact {

/// Largest number of scenes whose condition is computed: time grows with its cube.
inline constexpr Eigen::Index kMaxConditionRows = 2500;

/// Returns the condition of a model's conditionals. Each singular one has a line with the jitter that repairs it,
/// relative to its variance. A refused one has its reason. The last line has the smallest reciprocal condition number
/// of the others. Factorises every conditional: some tenths of a second for 1400 rows. A model of more
/// than kMaxConditionRows scenes is not factorised; its only line gives this reason.
std::string conditionsText(const ModelData& model, FeatureSet set);

}  // namespace terratact
