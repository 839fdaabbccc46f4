#pragma once

#include <string>

#include "core/learn/model/file/model_part.h"

namespace terratact::model_file {

/// Returns contentHash() of a checked model; with a portion: the hash of that part.
std::string hashOf(const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
