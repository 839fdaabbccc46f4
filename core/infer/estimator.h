#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/scene_sampling.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/bin_models.h"
#include "core/learn/model/clearance_conditionals.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/reduced_clearances.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Everything a trained model offers to the methods, prepared once, shared between threads.
struct Models {
    /// robot: the one the model was trained for.
    Models(const ModelData& model, const RobotModel& robot);

    BinModels pa, paf;
    ClearanceModel clearance;
    ClearanceConditionals conditionals;
    ReducedClearances reduced;
};

/// Makes all Gaussian processes that a sampling method may ask for, whatever the scene; nothing for a closed form.
/// Throws std::invalid_argument where one cannot be made, once the others are there; Cancelled.
void makeProcesses(const Models& models, const Settings& settings, const Watch& watch = {});

/// The estimate of one scene by settings.method, whichever that is.  Where s lacks currents or forces that the method
/// uses, by methodWithout() (missing_sensors.h); TerrainEstimate::missing and its warnings say what lacks.
/// Same scene, models and settings: the same result, bit for bit on one machine.
/// Throws std::invalid_argument for settings out of range, or weak heights with one
/// of the paper's methods, which know no measurement but exact ones; Cancelled.
TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch = {},
                                const WeakHeights& weak = {});

/// The same for a method for whose scene no chain is needed (isClosedForm of methodWithout).
TerrainEstimate closedFormEstimate(const Proprioception& s, std::span<const ArmReading> arm,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch = {},
                                   const WeakHeights& weak = {});

/// The same up to the sampling, for a method that samples; throws likewise.  Refers to the models.
SceneSampling sceneSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const Models& models, const Settings& settings,
                            const Watch& watch = {}, const WeakHeights& weak = {});

}  // namespace terratact
