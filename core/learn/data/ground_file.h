#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/store/csv_reader.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

struct GroundFile {
    std::vector<GroundLines> grounds;  ///< at least one
};

/// Reads ground from CSV (core/store/csv_reader.h), heights in metres, z up. A file without a
/// column y_m is read as readProfiles() reads it (core/learn/data/profile_file.h). Each profile is
/// then equal under every part of the robot. A file of lines has a header with these columns.
/// heights_m is the last one; the others may have any order:
///   pair       name of the ground. Consecutive lines of the same name belong to one ground. Without
///              this column all lines belong to one ground.
///   y_m        distance of the line from the robot's middle, left positive
///   step_m     distance of the heights of this line; `step` without this column
///   heights_m  the heights at equal steps, as many as there are. The first is at x = 0.
/// Other columns are ignored, and so is a line of units below the header. Lines of empty fields are
/// ignored, and lines that begin with # and have no y. `blocks` is that of
/// TerrainProfile::fromSamples.
///
/// Errors name file, line and cause. Causes: a missing or duplicate column; a line with fewer than two heights, or with
/// one that is no number; two lines of a ground with the same y; lines of a ground that do not stand together; |y|
/// beyond 2 m; a step beyond 0.001 … 10 m. What readProfiles() refuses is refused here, too. Throws
/// std::invalid_argument unless step is finite and above 0.
Result<GroundFile> readGrounds(const std::string& path, double step, bool blocks);

/// Reads the same from an open CSV.
Result<GroundFile> readGrounds(CsvReader csv, double step, bool blocks);

}  // namespace terratact
