#pragma once

#include <string>

#include "core/learn/model.h"

namespace terratact::model_file {

/// contentHash() of a model that has been checked.
std::string hashOf(const ModelData& model);

}  // namespace terratact::model_file
