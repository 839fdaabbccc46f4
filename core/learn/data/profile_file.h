#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/store/csv_reader.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Of all profiles of a file together.
inline constexpr std::size_t kMaxProfileNumbers = 2'000'000;

struct ProfileFile {
    std::vector<TerrainProfile> profiles;  ///< at least one
};

/// Reads terrain profiles from CSV (core/store/csv_reader.h), heights in metres, z up.  The first line of numbers decides:
///   two numbers   x,z of one profile; at least two points, x never decreasing, two points at the same x
///                 are a vertical face
///   three or more  heights at equal steps, every line one profile of its own length; the first height
///                 is at x = 0
/// A header may come first: x,z or x_m,z_m of points, any names of heights (then every line has as
/// many fields).  `step` [m] and `blocks` are those of TerrainProfile::fromSamples; points need neither.
///
/// Errors name file, line and cause: x that decreases or does not advance, a line of another form, wrong numbers, NaN or
/// infinity, heights beyond ±5 m of the profile's first, |x| beyond 1000 m, an empty file,
/// more than kMaxProfileNumbers numbers; whole numbers alone that are likely heights with decimal commas.
/// Throws std::invalid_argument unless step is finite and above 0.
Result<ProfileFile> readProfiles(const std::string& path, double step, bool blocks);

/// The same from its first line on.
Result<ProfileFile> readProfiles(CsvReader csv, double step, bool blocks);

}  // namespace terratact
