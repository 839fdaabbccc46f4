#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/ghost.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// An estimate of one of a session's scenes.
struct EstimateOfScene {
    std::size_t scene = 0;  ///< its place in SessionReader::scenes()
    const TerrainEstimate* estimate = nullptr;
};

/// Where an estimate has come to, by odometry, when a later scene was captured.
struct LaterPose {
    std::size_t estimate = 0;  ///< its place among those that were given
    std::size_t scene = 0;     ///< the later one
    Ghost ghost;
};

/// Follows estimates along the session's telemetry (infer/verdict/ghost_track.h), each to all the scenes behind its own that
/// it reaches, in the order of these scenes.  Bins that the training set alone speaks for go along.  Reads only frames between a scene and where its estimates have ended.
/// Throws std::invalid_argument where there is no such scene.
std::vector<LaterPose> laterPoses(SessionReader& session, const RobotModel& robot,
                                  std::span<const EstimateOfScene> estimates);

}  // namespace terratact
