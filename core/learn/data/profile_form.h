#pragma once

#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/learn/data/profile_file.h"
#include "core/store/csv_reader.h"

namespace terratact {

// Parts that files of profiles and of ground lines share.

/// Returns true if the current record is the header of a file of ground lines: it has a column y_m.
bool namesLines(const CsvReader& csv);

/// Returns the numbers in the current record's fields begin … end − 1.
Result<std::vector<double>> numbersOf(CsvReader& csv, std::size_t begin, std::size_t end);

/// Returns Done if a height lies within 1000 km of 0 and within 5 m of `first`. first: of the profile, or of the
/// ground's first line.
Status checkHeight(const CsvReader& csv, double height, double first);

/// Reads profiles, of which the current record is the first.
Result<ProfileFile> readProfilesFromHere(CsvReader csv, double step, bool blocks);

}  // namespace terratact
