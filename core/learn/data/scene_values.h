#pragma once

#include <cstddef>

#include "core/learn/data/scene.h"
#include "core/learn/data/scene_rows.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

// Rows of scenes and their columns, which files of scenes and of drives share.

/// Returns the columns of scenes of one plane (core/learn/data/scene_file.h).
const SceneColumns& planeSceneColumns();
/// Returns the columns of scenes of two tracks (core/learn/data/two_track_scene_file.h).
const SceneColumns& twoTrackSceneColumns();

/// Number of the last columns that hold the heights' sd.
inline constexpr std::size_t kPlaneSdColumns = kBins, kTwoTrackSdColumns = 2 * std::size_t{kBins};

/// Return the scene of a row. The numbers of the scene begin at row.values[first]; more may follow them. The columns of
/// the sd may be missing.
Scene planeSceneOf(const SceneFileRow& row, std::size_t first = 0);
TwoTrackScene twoTrackSceneOf(const SceneFileRow& row, std::size_t first = 0);

/// Return the row of a scene.
SceneFileRow sceneRow(const Scene& scene);
SceneFileRow sceneRow(const TwoTrackScene& scene);

}  // namespace terratact
