#pragma once

#include <string>

#include "core/learn/model/model_part.h"

namespace terratact::model_file {

/// Fills the empty file at `path` with a model, or a portion of one, that has been checked.  Throws SqliteError.
void fill(const std::string& path, const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
