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

/// Largest sd [m] of an exact measurement; the models do not move its height.
inline constexpr double kExactSd = 0.001;

/// Prepares one scene of Method::Clearance for sampleScene(), or for a caller that samples several
/// scenes at once (EstimateBatch). Gibbs sampling has the clearance as the state of a bin under the
/// robot (ClearanceStates). The result refers to the models.
/// Contacts and arm readings are noisy measurements of their bins and become their origin. Measured
/// bins are also drawn, unless the measurement's sd is at most kExactSd; then they keep its height.
/// The height to show is the median of the draws. No draw is above its ceiling. Convergence is
/// judged over all bins that are drawn.
/// The same scene, models and settings give the same estimate, bit for bit on one machine.
/// watch: used while models are factorised, which may happen when the chains start.
/// Throws std::invalid_argument for another method, for settings or readings out of range, and for
/// an s that lacks a feature. It also throws for a bin in an untrained regime. Throws Cancelled.
SceneSampling clearanceSampling(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const ClearanceConditionals& models,
                                const Settings& settings, const Watch& watch = {});

}  // namespace terratact
