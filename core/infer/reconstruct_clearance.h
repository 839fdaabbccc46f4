#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/scene_sampling.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/clearance_conditionals.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A measurement this exact [m] is not moved by what the models know.
inline constexpr double kExactSd = 0.001;

/// Method::Clearance: Gibbs sampling of the bins, the state of a bin under the robot being its clearance
/// (ClearanceStates).  Contacts and arm readings are noisy measurements of their bins, whose origin they become (weak heights are
/// that, too, but of no origin);
/// those bins are drawn too, unless the measurement's sd is at most kExactSd: then they stay there.  The height to show is the median of the draws; no draw is above its ceiling.
/// Convergence is judged over all bins that are drawn.
/// Same scene, models and settings: the same result, bit for bit on one machine.
/// Throws std::invalid_argument for another method, settings or readings out of range, an s that lacks a
/// feature, and where a bin is in a regime that was not trained or the model gives no finite estimate; Cancelled.
TerrainEstimate reconstructClearance(const Proprioception& s, std::span<const ArmReading> arm,
                                     const RobotModel& robot, const ClearanceConditionals& models,
                                     const Settings& settings, const Watch& watch = {},
                                     const WeakHeights& weak = {});

/// The same up to the sampling, for those who sample several scenes at once (EstimateBatch).  Refers to the models;
/// watch: while they are factorised, which may be when chains start.
SceneSampling clearanceSampling(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const ClearanceConditionals& models,
                                const Settings& settings, const Watch& watch = {},
                                const WeakHeights& weak = {});

}  // namespace terratact
