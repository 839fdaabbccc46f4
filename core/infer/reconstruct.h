#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/sampling/scene_sampling.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/bin_models.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// The paper's probabilistic reconstruction of one scene (sections 4.2 and 4.3): contacts and arm readings are
/// fixed, the other bins sampled.  models: of the feature set that settings.method uses, or of Pa, which needs no
/// current and no force.
/// Same scene, models and settings: the same result, bit for bit on one machine.
/// Throws std::invalid_argument for another method than the paper's four, settings out of range, a model of the other feature set or an s that
/// lacks a feature, or a model that gives no finite estimate; Cancelled.
TerrainEstimate reconstruct(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch = {});

/// The same up to the sampling, for those who sample several scenes at once (EstimateBatch).  Refers to the models;
/// watch: while they are factorised, which may be when chains start.
SceneSampling paperSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch = {});

/// Adds what breaks the 2-D assumption (roll, left/right difference) to a result's warnings.
void warnIfNotPlanar(TerrainEstimate& estimate, const Measurement& measurement);

}  // namespace terratact
