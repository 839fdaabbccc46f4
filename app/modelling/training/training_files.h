#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

/// Scenes of one or several files, whose columns may differ.
template <class SceneType>
struct TrainingScenes {
    std::vector<SceneType> scenes{};
    std::vector<std::size_t> begins{};  ///< first scene of each file
    std::string hash{};  ///< SHA-256 of a file; of several, of their hashes in hexadecimal
};

/// Receives the notices about each file.
using NoticeReport = std::function<void(const Message&)>;

/// Read scenes of one plane, or of two tracks, from at least one file. Errors are those of readScenes() and
/// readTwoTrackScenes().
Result<TrainingScenes<Scene>> readPlanes(const std::vector<std::string>& files,
                                         const NoticeReport& report);
Result<TrainingScenes<TwoTrackScene>> readTracks(const std::vector<std::string>& files,
                                                 const NoticeReport& report);

}  // namespace terratact
