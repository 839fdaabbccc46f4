#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/sampling/scene_sampling.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/bin_models.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Prepares one scene as in the paper (sections 4.2 and 4.3). The caller is sampleScene(), or samples
/// several scenes at once (EstimateBatch). Contacts and arm readings are fixed, the other
/// bins are sampled. models: of the feature set that settings.method uses, or of Pa, which needs no
/// current and no force. The result refers to them. The same scene, models and settings give the
/// same estimate, bit for bit on one machine.
/// watch: used while models are factorised, which may happen when the chains start.
/// Throws std::invalid_argument for a method that is not one of the paper's four, and for settings
/// out of range. It also throws for models of the other feature set and a missing feature. Throws
/// Cancelled.
SceneSampling paperSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch = {});

/// Adds a warning for each measurement that breaks the assumption of one plane: roll, flippers that
/// differ left and right, a track differential that has turned.
void warnIfNotPlanar(TerrainEstimate& estimate, const Measurement& measurement);

}  // namespace terratact
