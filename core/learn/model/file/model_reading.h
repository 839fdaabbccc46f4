#pragma once

#include "core/learn/model/file/model_file.h"
#include "core/learn/model/file/model_part.h"
#include "core/store/sqlite.h"

namespace terratact::model_file {

/// Reads and checks a whole model with its hash. Throws Refused and SqliteError.
StoredModel readStored(SqliteFile& file);

/// Reads and checks a part of a model in the same way.
ModelPart readStoredPart(SqliteFile& file);

}  // namespace terratact::model_file
