#pragma once

#include <string>

#include "core/learn/model.h"

namespace terratact::model_file {

/// Fills the empty file at `path` with a model that has been checked.  Throws SqliteError.
void fill(const std::string& path, const ModelData& model);

}  // namespace terratact::model_file
