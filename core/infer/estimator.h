#pragma once

#include <memory>
#include <optional>
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
#include "core/trail/trail_history.h"
#include "core/trail/trail_model.h"

namespace terratact {

/// A trained model prepared for every method, to be shared between threads.
struct Models {
    /// robot: the robot that the model was trained for.
    Models(const ModelData& model, const RobotModel& robot);

    BinModels pa, paf;
    ClearanceModel clearance;
    ClearanceConditionals conditionals;
    ReducedClearances reduced;
    /// Both sides of two tracks; empty if the model has learnt one plane only.
    std::optional<ClearanceModel> sides{};
    std::optional<ReducedClearances> reducedSides{};
    /// Networks of the method Trail; null: none, and Local estimates.
    std::shared_ptr<const TrailModel> trail{};
};

/// Makes all Gaussian processes that a sampling method may need in any scene; none for a closed
/// form. Throws std::invalid_argument if one cannot be made, after making the others; throws
/// Cancelled.
void makeProcesses(const Models& models, const Settings& settings, const Watch& watch = {});

/// Estimates one scene by settings.method. The method Trail uses `history`; without it, or without
/// models.trail, Local estimates with a warning. In place of Trail, it uses what the arm measured
/// earlier (earlierArm() of core/infer/trail_form.h). If s lacks currents or forces that the method
/// uses, methodWithout() chooses the method (core/infer/estimate/missing_sensors.h).
/// TerrainEstimate::missing and its warnings then name the missing features.
/// The same scene, models and settings give the same result, bit for bit on one machine.
/// Throws std::invalid_argument for settings out of range. Throws Cancelled.
TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch = {},
                                const TrailHistory* history = nullptr);

/// Estimates one scene by a method that needs no chain (isClosedForm of methodWithout). Throws as
/// estimateTerrain.
TerrainEstimate closedFormEstimate(const Proprioception& s, std::span<const ArmReading> arm,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch = {},
                                   const TrailHistory* history = nullptr);

/// Prepares a scene up to the sampling, for a method that samples. Throws as estimateTerrain. The
/// result refers to the models.
SceneSampling sceneSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const Models& models, const Settings& settings,
                            const Watch& watch = {});

}  // namespace terratact
