#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/two_track_scene.h"
#include "core/store/csv_reader.h"

namespace terratact {

struct TwoTrackSceneFile {
    std::vector<TwoTrackScene> scenes;
    std::vector<Message> notices;  ///< notices such as ignored unknown columns
};

/// Reads scenes of two tracks from CSV: a header, then one scene per line. Columns in any order:
///   run,t_s,pitch_rad,roll_rad,front_left_rad,front_right_rad,rear_left_rad,rear_right_rad,
///   front_left_current_a … rear_right_current_a,
///   front_left_force_1_n … front_left_force_6_n,front_right_force_1_n … front_right_force_6_n
/// and, if they are known,
///   differential_rad, rear_left_force_1_n … rear_right_force_6_n,
///   left_h_-0.3_m … left_h_+0.7_m, right_h_-0.3_m … right_h_+0.7_m,
///   left_sd_-0.3_m … right_sd_+0.7_m
/// A file without a column roll_rad is one of one plane (core/learn/data/scene_file.h); its scenes are
/// then onBothSides(). Empty fields, limits and errors are those of readScenes().
Result<TwoTrackSceneFile> readTwoTrackScenes(const std::string& path);

/// Reads scenes from an open CSV.
Result<TwoTrackSceneFile> readTwoTrackScenes(CsvReader csv);

/// Returns scenes in this format. Optional columns that no scene fills are left out. Numbers are
/// the shortest that read back equal. Throws std::invalid_argument for what the reader would refuse.
std::string twoTrackScenesText(const std::vector<TwoTrackScene>& scenes);

}  // namespace terratact
