#pragma once

#include "core/learn/model/model_file.h"
#include "core/learn/model/model_part.h"
#include "core/store/sqlite.h"

namespace terratact::model_file {

/// Reads and checks a whole model, its hash included.  Throws Refused and SqliteError.
StoredModel readStored(SqliteFile& file);

/// The same for a part of a model.
ModelPart readStoredPart(SqliteFile& file);

}  // namespace terratact::model_file
