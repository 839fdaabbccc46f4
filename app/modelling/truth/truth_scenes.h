#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/drive_lines.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

/// Scenes whose heights are wanted.
struct TruthScenes {
    bool isPlane = false;
    std::vector<TwoTrackScene> tracks{};  ///< every scene, on both sides
    std::vector<Scene> plane{};           ///< the same scenes, if they are of one plane
    std::vector<DriveLines> drives{};     ///< of a file of drives, which has these scenes
    std::vector<Message> notices{};
};

/// Reads a file of scenes, or of drives if it has a column kind. With a column roll_rad they are of two tracks. Errors
/// are those of readScenes(), readTwoTrackScenes() and readDrives(), or that it holds no scene.
Result<TruthScenes> readTruthScenes(const std::string& path);

}  // namespace terratact
