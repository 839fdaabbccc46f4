#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/strip/carried_estimate.h"

namespace terratact {

/// Estimate of one of a session's scenes.
struct EstimateOfScene {
    std::size_t scene = 0;  ///< index in SessionReader::scenes()
    const TerrainEstimate* estimate = nullptr;
};

/// Estimate carried by odometry to the pose of a later scene.
struct LaterPose {
    std::size_t estimate = 0;  ///< index in the estimates that were given
    std::size_t scene = 0;     ///< index of the later scene
    CarriedEstimate carried;
};

/// Carries each estimate along the session's telemetry (core/strip/carried_estimate.h). Returns it as
/// seen from all later scenes that it reaches, in their order. Frames after an estimate has ended are
/// not read. Throws std::invalid_argument for a scene that does not exist.
std::vector<LaterPose> laterPoses(SessionReader& session, const RobotModel& robot,
                                  std::span<const EstimateOfScene> estimates);

}  // namespace terratact
