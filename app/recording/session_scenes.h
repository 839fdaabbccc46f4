#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Adds the scenes of a session except those with the ids `repeated`. Left and right are averaged. The true heights are
/// those of the source. If it did not know them, they are those that flippers or arm touched
/// (core/infer/estimate/measured_bins.h). The readings of the arm and the settings are those of the scene's last
/// estimate. Of a bin that both touched, the arm's height counts. Other heights stay unknown. The run is named by the
/// drive in the file's name. robot: of the session; null: touched heights are not wanted. Throws like measureBins().
void addSessionScenes(const SessionReader& session, const std::set<std::int64_t>& repeated,
                      const RobotModel* robot, std::vector<Scene>& scenes);

/// Adds the same with the readings and heights of each side. A scene that knows means alone (hasSides()) becomes one
/// with equal sides.
void addSessionScenes(const SessionReader& session, const std::set<std::int64_t>& repeated,
                      const RobotModel* robot, std::vector<TwoTrackScene>& scenes);

/// Return the number of known heights of a scene, of both sides together.
std::size_t countKnownHeights(const Scene& scene);
std::size_t countKnownHeights(const TwoTrackScene& scene);

}  // namespace terratact
