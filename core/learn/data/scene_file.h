#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/learn/data/scene.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// No file holds more; it would take a day's drive at two scenes a second.
inline constexpr std::size_t kMaxScenes = 200'000;

struct SceneFile {
    std::vector<Scene> scenes;
    std::vector<std::string> notices;  ///< e.g. unknown columns that were kept out
    std::string
        hash;  ///< SHA-256 of the file's bytes, in hexadecimal digits; empty where it had no file
};

/// Reads scenes as CSV (core/store/csv_reader.h): a header, then one scene per line.  Columns in any order:
///   run,t_s,pitch_rad,front_rad,rear_rad,front_current_a,rear_current_a,
///   force_1_n … force_6_n,h_-0.3_m,h_-0.2_m,…,h_+0.0_m,…,h_+0.7_m
/// The h columns may be missing; an empty field, or NaN, NA and the like, means unknown (allowed for currents, forces,
/// heights); unknown columns are kept out with a notice; so is a last line without its line end named.  A line of
/// units below the header is passed over if they are these.
/// Errors name file, line and cause: missing, doubled or misspelt columns, wrong numbers, NaN or
/// infinity, heights beyond ±5 m, angles beyond ±π, forces below 0 or above 1000 N, currents beyond
/// ±100 A, other units, a wrong number of fields, an empty file, more than kMaxScenes scenes, what CsvReader refuses.
/// The file is read once, so that it may be a pipe.
Result<SceneFile> readScenes(const std::string& path);

/// readScenes() of a file from its first line on.
Result<SceneFile> readScenes(CsvReader csv);

/// readScenes() without the scenes of which no height is known; a notice says how many.  Also an error: none is left.
Result<SceneFile> readScenesWithTruth(const std::string& path);

/// Scenes in the same format, numbers shortest that read back equal.  Throws std::invalid_argument for what
/// readScenes would refuse.
std::string scenesText(const std::vector<Scene>& scenes);

/// Writes them to a temporary name, then renamed.
Status writeScenes(const std::string& path, const std::vector<Scene>& scenes);

}  // namespace terratact
