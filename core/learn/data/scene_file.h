#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// Largest number of scenes in one file: a day's drive at two scenes per second.
inline constexpr std::size_t kMaxScenes = 200'000;

struct SceneFile {
    std::vector<Scene> scenes;
    std::vector<Message> notices;  ///< notices such as ignored unknown columns
    std::string hash;  ///< SHA-256 of the file's bytes, hexadecimal; empty without a file
};

/// Reads scenes from CSV (core/store/csv_reader.h): a header, then one scene per line. Columns in
/// any order:
///   run,t_s,pitch_rad,front_rad,rear_rad,front_current_a,rear_current_a,
///   force_1_n … force_6_n,h_-0.3_m,h_-0.2_m,…,h_+0.0_m,…,h_+0.7_m,sd_-0.3_m … sd_+0.7_m
/// The h columns may be missing. So may the sd columns: the sd of each height, empty where it is
/// exact. An empty field, NaN, NA and so on mean unknown, which currents, forces and heights may
/// be. Unknown columns are ignored with a notice; a last line without its line end is also noticed.
/// A line of units below the header is skipped if the units are right. Errors name file, line and
/// cause. Causes: missing, duplicate or misspelt columns, wrong numbers, other units, a wrong
/// number of fields, an empty file. Infinity is refused, and NaN where a value must be known.
/// Limits are ±5 m for heights, ±π for angles, 0 … 1000 N for forces and ±100 A for currents. More
/// than kMaxScenes scenes are refused, and so is what CsvReader refuses. The file is read once, so
/// that it may be a pipe.
Result<SceneFile> readScenes(const std::string& path);

/// Reads scenes from an open CSV, as readScenes().
Result<SceneFile> readScenes(CsvReader csv);

/// Reads scenes from a CSV whose current record is the header.
Result<SceneFile> readScenesFromHere(CsvReader csv);

/// Reads scenes, and drops those without any known height; a notice has their number. It is an
/// error if none is left.
Result<SceneFile> readScenesWithTruth(const std::string& path);

/// Returns scenes in the same format. Numbers are the shortest that read back equal. Throws
/// std::invalid_argument for what readScenes would refuse.
std::string scenesText(const std::vector<Scene>& scenes);

/// Writes scenes to a temporary file and renames it.
Status writeScenes(const std::string& path, const std::vector<Scene>& scenes);

}  // namespace terratact
