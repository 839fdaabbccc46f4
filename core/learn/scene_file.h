#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "core/learn/scene.h"
#include "core/result.h"

namespace terratact {

struct SceneFile {
    std::vector<Scene> scenes;
    std::vector<std::string> notices;  ///< e.g. unknown columns that were kept out
};

/// Reads scenes as CSV: a header, then one scene per line.  Columns in any order:
///   run,t_s,pitch_rad,front_rad,rear_rad,front_current_a,rear_current_a,
///   force_1_n … force_6_n,h_-0.3_m,h_-0.2_m,…,h_+0.0_m,…,h_+0.7_m
/// The h columns may be missing; an empty field means unknown (allowed for currents, forces, heights);
/// unknown columns are kept out with a notice; LF or CRLF.
/// Errors name file, line and cause: missing, doubled or misspelt columns, wrong numbers, NaN or
/// infinity, heights beyond ±5 m, angles beyond ±π, forces below 0 or above 1000 N, currents beyond
/// ±100 A, a wrong number of fields, a torn last line, an empty file.
Result<SceneFile> readScenes(const std::string& path);

/// Writes the same format (numbers shortest that read back equal), to a temporary name, then renamed.
Status writeScenes(const std::string& path, const std::vector<Scene>& scenes);

}  // namespace terratact
