#pragma once

#include <cstddef>
#include <string>

#include "app/modelling/truth/laser_truth.h"
#include "core/base/result.h"
#include "core/store/file_group.h"

namespace terratact {

inline constexpr std::size_t kMaxSheetScenes = 40;  ///< of more scenes, as many spread evenly

/// Draws a contact sheet of scenes with a pose. Each scene shows the slice of the cloud under left and right. It
/// also shows the robot from the side, and the bins' heights with two sd. A scene without heights shows the reason.
/// The file is PNG, SVG or PDF by its ending, written under a temporary name and renamed. Errors name the file.
Status writeTruthSheet(const std::string& path, const LaserTruth& truth,
                       const FileWriter& write = {});

}  // namespace terratact
