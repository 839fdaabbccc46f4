#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/infer/estimator.h"
#include "core/learn/data/scene.h"
#include "core/learn/model/model_file.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Robot, model and what the methods make of it.
struct EstimatorBundle {
    EstimatorBundle(RobotModel robotModel, StoredModel storedModel)
        : robot(std::move(robotModel)), model(std::move(storedModel)), models(model.data, robot)
    {
    }

    RobotModel robot;
    StoredModel model;
    Models models;
};
Result<std::unique_ptr<EstimatorBundle>> openEstimatorBundle(const std::string& robotPath,
                                                             const std::string& modelPath);

/// Reconstructs one scene with what the arm has measured, by the settings' method.  Throws as reconstruct.
/// seconds: after which sampling ends with what there is; 0: no limit.
TerrainEstimate estimateWith(const Scene& scene, std::span<const ArmReading> arm,
                             const EstimatorBundle& bundle, const Settings& settings,
                             double seconds = 0.0);

/// An estimate of a scene, or why there is none.
struct SceneEstimate {
    std::optional<TerrainEstimate> estimate;
    std::string note;               ///< what makes it doubtful or impossible, in words
    std::vector<ArmReading> arm{};  ///< what the simulated arm has measured
};

/// Reconstructs one scene.  Pafac simulates the arm as the paper does: where some sd exceeds the limit, the
/// bin of the largest one in reach is read, and the rest sampled again.  A reading is the scene's truth plus normal
/// noise with the robot file's arm sd; the scene's seed decides it.
/// seconds: of every sampling, as above.
SceneEstimate estimateScene(const Scene& scene, const EstimatorBundle& bundle,
                            const Settings& settings, double seconds = 0.0);

/// All scenes, on all cores, several at a time on each (EstimateBatch) unless their seconds are limited; the seed of
/// scene k is settings.seed + k.  The estimates are those of estimateScene, bit for bit.
std::vector<SceneEstimate> estimateScenes(const std::vector<Scene>& scenes,
                                          const EstimatorBundle& bundle, const Settings& settings,
                                          double seconds = 0.0);

/// Puts the robot on every estimate's ground (core/sim/posterior_check.h), on all cores. An estimate that contradicts
/// its scene's readings says so, and so does its note. Returns how many do.
std::size_t checkEstimates(const std::vector<Scene>& scenes, const RobotModel& robot,
                           std::vector<SceneEstimate>& estimates);

}  // namespace terratact
