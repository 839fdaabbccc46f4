#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/store/csv_reader.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Largest number of numbers in all profiles of a file together.
inline constexpr std::size_t kMaxProfileNumbers = 2'000'000;

struct ProfileFile {
    std::vector<TerrainProfile> profiles;  ///< at least one
};

/// Reads terrain profiles from CSV (core/store/csv_reader.h), heights in metres, z up. The first
/// line of numbers decides the form:
///   two numbers    x,z of one profile: at least two points, x never decreasing. Two points at the
///                  same x are a vertical face.
///   three or more  heights at equal steps. Every line is one profile of its own length, and its first
///                  height is at x = 0.
/// A header may come first: x,z or x_m,z_m for points, any names for heights; every line then has
/// as many fields. `step` [m] and `blocks` are those of TerrainProfile::fromSamples, for heights
/// only.
///
/// Errors name file, line and cause. Causes are x that decreases or does not advance, a line of another form, wrong
/// numbers, NaN and infinity. Heights beyond ±5 m of the profile's first and |x| beyond 1000 m are refused. So are an
/// empty file, more than kMaxProfileNumbers numbers, and a header with a column y_m (core/learn/data/ground_file.h).
/// Integers that are probably heights with decimal commas are refused, too. Throws std::invalid_argument unless step is
/// finite and above 0.
Result<ProfileFile> readProfiles(const std::string& path, double step, bool blocks);

/// Reads the same from an open CSV.
Result<ProfileFile> readProfiles(CsvReader csv, double step, bool blocks);

}  // namespace terratact
