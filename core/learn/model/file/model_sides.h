#pragma once

#include <vector>

#include "core/learn/model/model.h"
#include "core/store/sqlite.h"
#include "core/store/sqlite_tables.h"

namespace terratact::model_file {

/// Returns the tables of a model's two tracks: surfaceTables() and side_row, one row per scene. Its
/// numbers are integers, multiples of the steps of side_training.h.
std::vector<SqliteTable> sideTables();

inline constexpr const char* kSidesExplanation = "side_row: one scene of two tracks, from the left "
                                                 "side; its mirror image is the second training "
                                                 "row; integers in 0.1 mrad, mA, 10 mN, 0.1 mm and "
                                                 "0.0001 y; side_surface as surface, for the own "
                                                 "side";

void writeSides(SqliteFile& file, const SurfaceData& sides);

/// Reads the same. Throws Refused if tables disagree; requireModel() checks the numbers.
SurfaceData readSides(SqliteFile& file);

}  // namespace terratact::model_file
