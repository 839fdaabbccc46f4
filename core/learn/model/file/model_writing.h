#pragma once

#include <string>

#include "core/learn/model/file/model_part.h"

namespace terratact::model_file {

/// Fills the empty file at `path` with a checked model or a portion of one. Throws SqliteError.
void fill(const std::string& path, const ModelData& model, const Portion* portion = nullptr);

}  // namespace terratact::model_file
